using System.Globalization;
using System.Text;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>One drawing in every form of DXF.</summary>
public class FormTests
{
    private static readonly DxfText Everything = OddDrawings.OneOfEverything();

    public static TheoryData<string, int> CodePages => new()
    {
        { "ANSI_874", 874 }, { "ANSI_932", 932 }, { "ANSI_936", 936 }, { "ANSI_949", 949 }, { "ANSI_950", 950 }, { "ANSI_1250", 1250 }, { "ANSI_1251", 1251 }, { "ANSI_1252", 1252 },
        { "ANSI_1253", 1253 }, { "ANSI_1254", 1254 }, { "ANSI_1255", 1255 }, { "ANSI_1256", 1256 }, { "ANSI_1257", 1257 }, { "ANSI_1258", 1258 }, { "ANSI_1361", 1361 },
        { "DOS437", 437 }, { "DOS737", 737 }, { "DOS775", 775 }, { "DOS850", 850 }, { "DOS852", 852 }, { "DOS855", 855 }, { "DOS857", 857 }, { "DOS860", 860 }, { "DOS861", 861 }, { "DOS863", 863 },
        { "DOS864", 864 }, { "DOS865", 865 }, { "DOS866", 866 }, { "DOS869", 869 }, { "DOS932", 932 }, { "BIG5", 950 }, { "GB2312", 936 }, { "KSC5601", 949 }, { "JOHAB", 1361 }, { "MACINTOSH", 10000 },
        { "ISO8859-1", 28591 }, { "ISO8859-2", 28592 }, { "ISO8859-3", 28593 }, { "ISO8859-4", 28594 }, { "ISO8859-5", 28595 }, { "ISO8859-6", 28596 }, { "ISO8859-7", 28597 }, { "ISO8859-8", 28598 },
        { "ISO8859-9", 28599 }, { "ISO8859-15", 28605 }, { "GB18030", 54936 }, { "ansi_1250", 1250 }, { "dos852", 852 },
    };

    [Theory]
    [MemberData(nameof(CodePages))]
    public void Every_code_page_in_use_gives_its_letters(string declared, int number)
    {
        var encoding = CodePagesEncodingProvider.Instance.GetEncoding(number) ?? Encoding.GetEncoding(number);
        var name = Letters(encoding);
        var text = new DxfText().Section("HEADER", (9, "$ACADVER"), (1, "AC1015"), (9, "$INSUNITS"), (70, 4), (9, "$DWGCODEPAGE"), (3, declared)).Section("ENTITIES", (0, "TEXT"), (8, name), (10, 0), (20, 0), (40, 1), (1, name)).End();
        var drawing = DxfReading.Of(encoding.GetBytes(Encoding.UTF8.GetString(text.ToAscii())));

        Assert.True(name.Length > 3);
        Assert.Equal(name, drawing.Layers[1].Name);
        Assert.Equal(name, Assert.Single(drawing.Texts).Content);
        Assert.Empty(drawing.Diagnostics);
    }

    [Theory]
    [InlineData("AC1002")]
    [InlineData("AC1009")]
    [InlineData("AC1012")]
    [InlineData("AC1014")]
    [InlineData("AC1018")]
    [InlineData("AC1021")]
    [InlineData("AC1032")]
    [InlineData("AC9999")]
    [InlineData("MC0.0")]
    [InlineData("")]
    public void Every_version_reads_the_same_and_is_named(string version)
    {
        var drawing = DxfReading.Of(new DxfText().Header(version, 4).Section("ENTITIES", OddDrawings.LwPolyline).End());

        Assert.Equal((version, 1), (drawing.DxfVersion, drawing.Balance.Cut));
    }

    [Theory]
    [InlineData("utf-16LE", true)]
    [InlineData("utf-16LE", false)]
    [InlineData("utf-16BE", true)]
    [InlineData("utf-16BE", false)]
    [InlineData("utf-8", true)]
    public void Unicode_forms_read_like_ascii(string name, bool mark)
    {
        var text = new DxfText().Header("AC1015", 4).Section("ENTITIES", [(0, "TEXT"), (8, "Größe 切断"), (10, 0), (20, 0), (40, 1), (1, "Ø5"), .. OddDrawings.Arc]).End();
        var encoding = Encoding.GetEncoding(name);
        var plain = Encoding.UTF8.GetString(text.ToAscii());
        var drawing = DxfReading.Of([.. mark ? encoding.GetPreamble() : [], .. encoding.GetBytes(plain)]);

        Assert.Equal(("Größe 切断", "Ø5", 1), (drawing.Layers[1].Name, drawing.Texts[0].Content, drawing.Balance.Cut));
        Assert.Empty(drawing.Diagnostics);
    }

    [Theory]
    [InlineData("\r\n")]
    [InlineData("\r")]
    [InlineData("\r\r\n")]
    public void Everything_reads_the_same_with_every_line_end(string lineEnd) =>
        Assert.Equal(DxfReading.Fingerprint(DxfReading.Of(Everything)), DxfReading.Fingerprint(DxfReading.Of(Everything.ToAscii(lineEnd))));

    [Fact]
    public void Line_ends_may_change_in_the_middle()
    {
        string[] ends = ["\n", "\r\n", "\r\r\n", "\r\n"];
        var lines = Encoding.UTF8.GetString(Everything.ToAscii()).Split('\n')[..^1];
        var mixed = string.Concat(lines.Select((line, i) => line + ends[i / 3 % ends.Length]));

        Assert.Equal(DxfReading.Fingerprint(DxfReading.Of(Everything)), DxfReading.Fingerprint(DxfReading.Of(mixed)));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Everything_reads_the_same_in_both_binary_layouts(bool oneByteCodes) =>
        Assert.Equal(DxfReading.Fingerprint(DxfReading.Of(Everything)), DxfReading.Fingerprint(DxfReading.Of(Everything.ToBinary(oneByteCodes))));

    [Fact]
    public void Comments_missing_and_doubled_handles_change_nothing()
    {
        (int, object)[] pairs = [(0, "LINE"), (5, "A"), (10, 0), (999, "0"), (20, 0), (999, "ENDSEC"), (11, 1), (21, 0), (0, "LINE"), (5, "A"), (10, 1), (20, 0), (11, 2), (21, 0), (0, "LINE"), (10, 2), (20, 0), (11, 3), (21, 0)];
        var drawing = DxfReading.Entities(pairs);

        Assert.Equal((3, 3), (drawing.Balance.Read, drawing.Balance.Cut));
        Assert.Empty(drawing.Diagnostics);
    }

    [Fact]
    public void A_section_that_never_ends_and_one_that_never_began_lose_nothing()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Add((0, "ENDSEC"), (0, "SECTION"), (2, "BLOCKS")).Add(OddDrawings.Block("A", OddDrawings.Arc)).Add((0, "SECTION"), (2, "ENTITIES")).Add(OddDrawings.Insert("A", 2.0)).End());

        Assert.Equal((1, 1), (drawing.Balance.Read, drawing.Balance.Cut));
        Assert.Equal("DXF0032", string.Join(' ', DxfReading.Ids(drawing).Distinct()));
    }

    public static TheoryData<string, byte[]> ForeignFiles => new()
    {
        { "DXB", [.. "AutoCAD DXB 1.0\r\n\u001A\0"u8, 1, 2] }, { "PDF", "%PDF-1.4\n"u8.ToArray() }, { "ZIP", [0x50, 0x4B, 3, 4, 20, 0] }, { "gzip", [0x1F, 0x8B, 8, 0] },
        { "SVG", "<?xml version=\"1.0\"?>\n<svg xmlns=\"x\"></svg>"u8.ToArray() }, { "web page", "\n<!DOCTYPE html><html></html>"u8.ToArray() }, { "PNG", [0x89, 0x50, 0x4E, 0x47, 13, 10] },
        { "STEP", "ISO-10303-21;\nHEADER;"u8.ToArray() }, { "DWG", "AC1032\0\0\0\0\0\u0001"u8.ToArray() },
    };

    [Theory]
    [MemberData(nameof(ForeignFiles))]
    public void A_file_of_another_format_is_named_and_refused_with_a_way_out(string name, byte[] file)
    {
        var finding = Assert.Single(DxfReading.Of(file).Diagnostics);

        Assert.Contains(name, finding.Message, StringComparison.Ordinal);
        Assert.Contains("DXF", finding.Rule.Advice, StringComparison.Ordinal);
    }

    [Fact]
    public void Everything_cut_anywhere_never_throws_and_its_balance_holds()
    {
        foreach (var file in new[] { Everything.ToAscii(), Everything.ToBinary(true), Everything.ToBinary(false) })
        {
            for (var length = 0; length < file.Length; length++)
            {
                var balance = DxfReading.Of(file[..length], new DxfReadOptions(Cut: (CutChoice)31)).Balance;
                Assert.True(balance.Read == balance.Cut + balance.Construction + balance.Refused.Count, length.ToString(CultureInfo.InvariantCulture));
            }
        }
    }

    /// <summary>A few letters of the code page's upper half (for two-byte pages: of their tables) that can be converted in both directions.</summary>
    private static string Letters(Encoding encoding)
    {
        var candidates = Enumerable.Range(0xA0, 0x5C0).Concat(Enumerable.Range(0x3041, 40)).Concat(Enumerable.Range(0x4E00, 40)).Concat(Enumerable.Range(0xAC00, 40)).Concat(Enumerable.Range(0xE01, 30)).Concat(Enumerable.Range(0xFE80, 60)).Select(code => ((char)code).ToString());
        return string.Concat(candidates.Where(letter => char.IsLetter(letter[0]) && encoding.GetString(encoding.GetBytes(letter)) == letter).TakeLast(6));
    }
}
