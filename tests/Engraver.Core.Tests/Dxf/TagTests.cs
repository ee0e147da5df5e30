using System.Globalization;
using System.Text;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Dxf;

public class TagTests
{
    private static readonly DxfText Sample = new DxfText()
        .Header("AC1015", 4)
        .Section("TABLES", (0, "TABLE"), (2, "LAYER"), (0, "LAYER"), (2, "CUT"), (70, 0), (62, -3), (290, 0), (0, "ENDTAB"))
        .Section("BLOCKS", (0, "BLOCK"), (2, "B"), (10, 1.0), (20, 1.0), (0, "LINE"), (8, "0"), (10, 1.0), (20, 1.0), (11, 2.5), (21, 1.0), (0, "ENDBLK"))
        .Section(
            "ENTITIES",
            (0, "LINE"), (5, "2F"), (8, "CUT"), (10, 0.1), (20, -0.25), (30, 1e-3), (11, 1e10), (21, 2.0), (31, 0.0), (1040, 7.0),
            (0, "LWPOLYLINE"), (90, 2), (70, 1), (10, 0.0), (20, 0.0), (42, 0.5), (10, 10.0), (20, 0.0),
            (0, "INSERT"), (2, "B"), (10, 5.0), (20, 5.0), (50, 30.0),
            (0, "TEXT"), (1, "hello"), (10, 0.0), (20, 0.0))
        .End();

    [Theory]
    [InlineData("\r\n")]
    [InlineData("\r")]
    [InlineData("\r\r\n")]
    public void Every_line_end_reads_the_same(string lineEnd) =>
        Assert.Equal(DxfReading.Fingerprint(DxfReading.Of(Sample)), DxfReading.Fingerprint(DxfReading.Of(Sample.ToAscii(lineEnd))));

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Both_binary_layouts_read_like_text(bool oneByteCodes)
    {
        var binary = DxfReading.Of(Sample.ToBinary(oneByteCodes));

        Assert.Equal("binary", binary.Encoding);
        Assert.Equal(DxfReading.Fingerprint(DxfReading.Of(Sample)), DxfReading.Fingerprint(binary));
        Assert.Equal(3, binary.Entities.Count);
    }

    [Fact]
    public void Byte_order_mark_comments_and_blanks_around_codes_change_nothing()
    {
        var text = Encoding.UTF8.GetString(Sample.ToAscii());
        var dressed = "\uFEFF999\nmade by hand\n\n" + text.Replace("  0\nLINE", "\t 0  \n  LINE ", StringComparison.Ordinal) + "\u001A\0\0";

        Assert.Equal(DxfReading.Fingerprint(DxfReading.Of(text)), DxfReading.Fingerprint(DxfReading.Of(dressed)));
    }

    [Property]
    public bool Every_double_comes_back_exactly_in_every_spelling(NormalFloat number, byte format)
    {
        var value = number.Get % 1e90;
        string[] formats = ["R", "E16", "F9", "G15", "0.0######;-.5"];
        var text = value.ToString(formats[format % formats.Length], CultureInfo.InvariantCulture);
        var drawing = DxfReading.Entities((0, "LINE"), (10, text), (20, 0), (11, 1e99), (21, 0));
        return drawing.Parts[0].A == double.Parse(text, CultureInfo.InvariantCulture);
    }

    [Theory]
    [InlineData("12.", 12.0)]
    [InlineData(".5", 0.5)]
    [InlineData("+12.5", 12.5)]
    [InlineData("  12.5\t", 12.5)]
    [InlineData("1e3", 1000.0)]
    [InlineData("1.7976931348623157e-308", 1.7976931348623157e-308)]
    [InlineData("9007199254740993", 9007199254740992.0)]
    [InlineData("0.30000000000000004", 0.30000000000000004)]
    [InlineData("123456789012345678901234567890", 1.2345678901234568e29)]
    [InlineData("18446744073709551617", 18446744073709551617.0)] // one more than 64 bits hold
    public void Numbers_may_be_written_in_many_ways(string text, double value) =>
        Assert.Equal(value, DxfReading.Entities((0, "LINE"), (10, text), (20, 0), (11, 1), (21, 1)).Parts[0].A);

    [Theory]
    [InlineData("12,5", 12.5)]
    [InlineData("-,5", -0.5)]
    [InlineData("1.25D+01", 12.5)]
    [InlineData("1,5d-3", 0.0015)]
    public void A_decimal_comma_and_a_Fortran_exponent_are_read_with_a_warning(string text, double value)
    {
        var drawing = DxfReading.Entities((0, "LINE"), (5, "A1"), (10, text), (20, 0), (11, 1), (21, 1));

        Assert.Equal(value, drawing.Parts[0].A);
        var warning = Assert.Single(drawing.Diagnostics);
        Assert.Equal(("DXF0037", 24L, "A1"), (warning.Id, warning.Source.Line, warning.Source.Handle));
        Assert.Contains($"'{text}'", warning.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("1,234.5")]
    [InlineData("1,2,3")]
    [InlineData("")]
    [InlineData("NaN")]
    [InlineData("-Infinity")]
    [InlineData("1e999")]
    [InlineData("1e101")]
    [InlineData("0x10")]
    [InlineData("1_0")]
    [InlineData("1.25D+01E")]
    [InlineData("1.2.3")]
    [InlineData("-")]
    [InlineData("1e")]
    [InlineData("１２")]
    public void What_is_no_number_costs_its_entity_and_no_other(string text)
    {
        var drawing = DxfReading.Entities((0, "LINE"), (5, "A1"), (10, text), (20, 0), (11, 1), (21, 1), (0, "CIRCLE"), (10, 0), (20, 0), (40, 1));

        var refused = Assert.Single(drawing.Balance.Refused);
        Assert.Equal(("LINE", "A1", "DXF0007"), (refused.Type, refused.Handle, refused.DiagnosticId));
        Assert.Equal(24, refused.Line); // the line of the value: eleven pairs and a code come before it
        Assert.Equal(1, drawing.Entities.Count);
    }

    [Fact]
    public void Cutting_a_file_anywhere_never_throws_and_always_says_so()
    {
        foreach (var file in new[] { Sample.ToAscii(), Sample.ToBinary(true), Sample.ToBinary(false) })
        {
            for (var length = 0; length < file.Length - 4; length++)
            {
                var drawing = DxfReading.Of(file[..length]);

                Assert.True(drawing.HasErrors, $"{length} of {file.Length} bytes");
                Assert.Equal(drawing.Balance.Read, drawing.Balance.Cut + drawing.Balance.Construction + drawing.Balance.Refused.Count);
            }
        }
    }

    /// <summary>A value in a binary file whose length does not match its code: 2000 is not a code, so the following data cannot be interpreted.</summary>
    [Theory]
    [InlineData("ENTITIES OBJECTS", "DXF0044")]
    [InlineData("OBJECTS ENTITIES", "DXF0005")]
    [InlineData("ENTITIES OBJECTS BLOCKS", "DXF0005")]
    [InlineData("ENTITIES OTHER", "DXF0005")]
    [InlineData("OBJECTS", "DXF0044")]
    public void What_cannot_be_read_is_no_loss_only_behind_all_that_is_cut(string sections, string id)
    {
        var text = new DxfText().Header("AC1015", 4);
        foreach (var name in sections.Split(' '))
        {
            if (name is "ENTITIES") text.Section(name, (0, "LINE"), (10, 0.0), (20, 0.0), (11, 1.0), (21, 1.0));
            else text.Section(name, (0, "THING"), (2000, "x"));
        }

        foreach (var oneByteCodes in new[] { false, true })
        {
            var file = text.ToBinary(oneByteCodes).ToArray();
            Assert.Equal("DXF0005", DxfReading.Ids(DxfReading.Of(file))[^1]); // no EOF
            Assert.Equal(id, DxfReading.Ids(DxfReading.Of([.. file, .. new DxfText().End().ToBinary(oneByteCodes)[22..]]))[^1]);
        }
    }

    [Property]
    public void Changing_any_bytes_never_throws((int Where, byte What)[] changes)
    {
        foreach (var file in new[] { Sample.ToAscii(), Sample.ToBinary(true), Sample.ToBinary(false) })
        {
            foreach (var (where, what) in changes) file[(int)((uint)where % file.Length)] = what;
            var balance = DxfReading.Of(file).Balance;
            Assert.Equal(balance.Read, balance.Cut + balance.Construction + balance.Refused.Count);
        }
    }

    [Fact]
    public void An_entity_that_the_end_of_the_file_cuts_is_not_guessed()
    {
        var drawing = DxfReading.Of("0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n20\n0\n11\n10\n21\n12");

        Assert.Equal(0, drawing.Entities.Count);
        Assert.Contains("DXF0031", DxfReading.Ids(drawing));
    }

    [Fact]
    public void After_a_lost_line_reading_goes_on_at_the_next_record()
    {
        var drawing = DxfReading.Of("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nCUT\n10\n20\n0\n11\n1\n21\n1\n0\nCIRCLE\n8\nCUT\n10\n0\n20\n0\n40\n1\n0\nENDSEC\n0\nEOF\n");

        Assert.Equal("Circle", TypesOf(drawing));
        Assert.Contains(drawing.Balance.Refused, refused => refused.Type == "LINE");
    }

    [Fact]
    public void An_empty_line_too_many_is_passed_over()
    {
        var drawing = DxfReading.Of("0\nSECTION\n2\nENTITIES\n0\nLINE\n\n10\n0\n20\n0\n11\n1\n21\n1\n0\nENDSEC\n0\nEOF\n");

        Assert.Equal("Line", TypesOf(drawing));
    }

    private static string TypesOf(Core.Drawings.Drawing drawing) => string.Join(' ', DxfReading.Curves(drawing).Select(entity => entity.Type));
}
