using System.Globalization;
using System.Text;
using Engraver.Core.Drawings;
using Engraver.TestKit;
using Engraver.Tools.CrossChecks;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Damage outside of entities (heads and ends of sections, tables and blocks) must not lose an entity silently, in either reader.</summary>
public class SilentLossTests
{
    private static readonly (int, object)[] Line = [(0, "LINE"), (5, "2F"), (8, "CUT"), (10, 0.0), (20, 0.0), (11, 7.0), (21, 3.0)];

    private static readonly (int, object)[] Circle = [(0, "CIRCLE"), (5, "30"), (8, "CUT"), (10, 50.0), (20, 0.0), (40, 4.0)];

    private static readonly (int, object)[] Polyline =
        [(0, "POLYLINE"), (5, "31"), (8, "CUT"), (66, 1), (70, 0), (0, "VERTEX"), (8, "CUT"), (10, 0.0), (20, 0.0), (0, "VERTEX"), (8, "CUT"), (10, 9.0), (20, 0.0), (0, "VERTEX"), (8, "CUT"), (10, 9.0), (20, 8.0), (0, "SEQEND"), (5, "32"), (8, "CUT")];

    private static readonly (int, object)[] Text = [(0, "TEXT"), (5, "33"), (8, "CUT"), (10, 1.0), (20, 1.0), (40, 2.5), (1, "x")];

    /// <summary>A hidden layer, a block, a polyline, texts: with each kind of skipped record in front of one that is read.</summary>
    private static readonly DxfText Sample = new DxfText()
        .Header("AC1015", 4)
        .Section("TABLES", (0, "TABLE"), (2, "LAYER"), (5, "2"), (70, 2), (0, "LAYER"), (5, "10"), (2, "HIDDEN"), (70, 1), (62, -7), (6, "CONTINUOUS"), (0, "LAYER"), (5, "11"), (2, "CUT"), (70, 0), (62, 3), (6, "CONTINUOUS"), (0, "ENDTAB"))
        .Section("BLOCKS", [(0, "BLOCK"), (5, "20"), (8, "0"), (2, "A"), (70, 0), (10, 0.0), (20, 0.0), .. Line, .. Circle, (0, "ENDBLK"), (5, "21"), (8, "0"), (0, "BLOCK"), (5, "22"), (8, "0"), (2, "B"), (70, 0), (10, 1.0), (20, 1.0), .. Polyline, (0, "ENDBLK"), (5, "23"), (8, "0")])
        .Section("ENTITIES", [.. Line, (8, "HIDDEN"), .. Circle, .. Polyline, .. Line, .. Text, .. Circle, .. Insert("A", 20.0), .. Insert("B", 40.0), .. Text, .. Line])
        .Section("OBJECTS", (0, "DICTIONARY"), (5, "C"), (3, "ACAD_GROUP"), (350, "D"))
        .End();

    /// <summary>The same with the sections without cuts: classes in front, a preview picture after them.</summary>
    private static readonly DxfText Framed = new DxfText()
        .Add([.. Sample.Pairs.TakeWhile(pair => !Equals(pair.Value, "TABLES")).SkipLast(1)])
        .Section("CLASSES", (0, "CLASS"), (1, "WIPEOUT"), (2, "AcDbWipeout"), (3, "ObjectDBX"), (90, 127), (280, 0))
        .Add([(0, "SECTION"), .. Sample.Pairs.SkipWhile(pair => !Equals(pair.Value, "TABLES")).SkipLast(1)])
        .Section("THUMBNAILIMAGE", (90, 4))
        .End();

    /// <summary>A longer run of zeros cannot be the value of a group: some of it reads as a record without a name.</summary>
    private const int LongestValue = 16;

    private static readonly string[] FrameTypes = ["SECTION", "ENDSEC", "CLASS", "TABLE", "ENDTAB", "ENDBLK", "SEQEND", "DICTIONARY", "EOF"];

    public static TheoryData<string?> Damages => [null, "O", "8", "5", "1", "x0", " 0 0", "LINE"];

    /// <summary>Each line 0 of the drawing, lost or damaged: all curves are read, or an error is reported.</summary>
    [Theory]
    [MemberData(nameof(Damages))]
    public void A_record_whose_0_is_lost_or_damaged_is_never_lost_without_an_error(string? instead)
    {
        var lines = Lines(Sample);
        var silent = new List<string>();
        for (var code = 0; code < lines.Length; code += 2)
        {
            if (lines[code].Trim() != "0" || lines[code + 1] is "EOF" or "DICTIONARY" || code == 0) continue;
            List<string> damaged = [.. lines];
            if (instead is null) damaged.RemoveAt(code);
            else damaged[code] = instead;
            if (Silence(damaged) is { } loss) silent.Add($"{instead ?? "nothing"} for the 0 of line {code + 1} in front of {lines[code + 1]}: {loss}");
        }

        Assert.Empty(silent);
    }

    /// <summary>Both lines of a record's head are lost, the 0 and the name: its values are appended to the previous record.</summary>
    [Fact]
    public void A_record_whose_head_is_lost_whole_is_never_lost_without_an_error()
    {
        var lines = Lines(Sample);
        var silent = new List<string>();
        for (var code = 0; code < lines.Length; code += 2)
        {
            if (lines[code].Trim() != "0" || lines[code + 1] is not ("LINE" or "CIRCLE" or "POLYLINE" or "VERTEX" or "INSERT" or "TEXT" or "LAYER")) continue;
            List<string> damaged = [.. lines];
            damaged.RemoveRange(code, 2);
            if (!Read(damaged).HasErrors) silent.Add($"line {code + 1}, {lines[code + 1]}: {string.Join(' ', DxfReading.Ids(Read(damaged)))}");
        }

        Assert.Empty(silent);
    }

    /// <summary>In a polyline or a spline, the values of a second record look like further values of the first.</summary>
    [Theory]
    [InlineData("0 LWPOLYLINE|8 CUT|90 2|70 0|10 0|20 0|10 9|20 0")]
    [InlineData("0 SPLINE|8 CUT|70 8|71 1|72 4|73 2|40 0|40 0|40 1|40 1|10 0|20 0|10 9|20 0")]
    public void A_line_that_ran_into_a_curve_of_many_points_is_an_error(string curve)
    {
        (int, object)[] pairs = [.. curve.Split('|').Select(pair => pair.Split(' ')).Select(pair => (int.Parse(pair[0], CultureInfo.InvariantCulture), (object)pair[1]))];

        Assert.False(DxfReading.Of(new DxfText().Header("AC1015", 4).Section("ENTITIES", pairs).End().ToAscii()).HasErrors);
        Assert.True(DxfReading.Of(new DxfText().Header("AC1015", 4).Section("ENTITIES", [.. pairs, .. Line[1..]]).End().ToAscii()).HasErrors);
    }

    /// <summary>A name that is empty, truncated or misspelt by one letter is a lost curve, not an unknown type.</summary>
    [Theory]
    [InlineData("")]
    [InlineData("LIN3")]
    [InlineData("LI")]
    [InlineData("L\u0001NE")]
    [InlineData("CIRCLF")]
    [InlineData("LWPOLYLIME")]
    public void A_record_whose_name_is_damaged_is_an_error_that_names_it(string name)
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("ENTITIES", [.. Circle, (0, name), .. Line[1..]]).End().ToBinary(oneByteCodes: false));

        var refused = Assert.Single(drawing.Balance.Refused);
        Assert.Equal((name, "DXF0058"), (refused.Type, refused.DiagnosticId));
        Assert.True(drawing.HasErrors);
    }

    /// <summary> Zeros in a binary file read as records without a name, wherever they start: heads and ends of sections and blocks, CLASSES, tables, entities,
    /// OBJECTS. A changed value that is also valid, such as the name or the flags of a layer, cannot be detected; therefore only the number of curves is
    /// compared. </summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_run_of_zeros_in_a_binary_file_is_never_passed_over_in_silence(bool oneByteCodes)
    {
        var file = Framed.ToBinary(oneByteCodes);
        var whole = Types(DxfReading.Of(file));
        var silent = new List<string>();
        foreach (var length in TestExtent.IsFull ? (int[])[1, 8, 19, 40, 120, 512] : [512])
        {
            for (var at = 22 + (length % 2); at < file.Length; at += 2)
            {
                byte[] damaged = [.. file];
                damaged.AsSpan(at, Math.Min(length, file.Length - at)).Clear();
                var read = DxfReading.Of(damaged);
                if (Types(read) == whole) continue;
                if (!read.HasErrors) silent.Add($"{length} bytes at {at}: the reader says '{string.Join(' ', DxfReading.Ids(read))}'");
                else if (length > LongestValue && CrossCheck.Read(damaged).DifferencesFrom(DrawingSummary.From(read)).Count == 0) silent.Add($"{length} bytes at {at}: the second reading agrees");
            }
        }

        Assert.Empty(silent);
    }

    /// <summary>Every byte of a skipped record is changed in four ways.</summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_damaged_byte_in_the_frame_of_a_binary_file_is_never_passed_over_in_silence(bool oneByteCodes)
    {
        var file = Framed.ToBinary(oneByteCodes);
        var whole = Types(DxfReading.Of(file));
        var silent = new List<string>();
        foreach (var at in FrameBytes(oneByteCodes))
        {
            foreach (var instead in (byte[])[(byte)(file[at] ^ 1), (byte)(file[at] ^ 0x80), (byte)(file[at] + 5), byte.MaxValue])
            {
                byte[] damaged = [.. file];
                damaged[at] = instead;
                var read = DxfReading.Of(damaged);
                if (!read.HasErrors && Types(read) != whole) silent.Add($"{instead} for {file[at]} at {at}: {string.Join(' ', DxfReading.Ids(read))}");
            }
        }

        Assert.Empty(silent);
    }

    [Fact]
    public void A_section_whose_name_is_damaged_is_never_dropped_without_an_error()
    {
        var lines = Lines(Sample);
        var silent = new List<string>();
        for (var value = 1; value < lines.Length; value += 2)
        {
            if (lines[value] is not ("TABLES" or "BLOCKS" or "ENTITIES") || lines[value - 1].Trim() != "2") continue;
            for (var at = 0; at < lines[value].Length; at++)
            {
                List<string> damaged = [.. lines];
                damaged[value] = string.Create(CultureInfo.InvariantCulture, $"{lines[value][..at]}5{lines[value][(at + 1)..]}");
                if (Silence(damaged) is { } loss) silent.Add($"{damaged[value]}: {loss}");
            }
        }

        Assert.Empty(silent);
    }

    [Theory]
    [InlineData("LAYER", "LAY3R")]
    [InlineData("BLOCK", "BL0CK")]
    [InlineData("ENDBLK", "ENDB1K")]
    [InlineData("ENDSEC", "ENDSEX")]
    [InlineData("ENDTAB", "ENDTAD")]
    [InlineData("SECTION", "SECTI0N")]
    public void A_frame_whose_name_is_damaged_is_never_passed_over_without_an_error(string name, string instead)
    {
        var lines = Lines(Sample);
        var silent = new List<string>();
        for (var value = 1; value < lines.Length; value += 2)
        {
            if (lines[value] != name || lines[value - 1].Trim() != "0" || value == 1) continue;
            List<string> damaged = [.. lines];
            damaged[value] = instead;
            if (Silence(damaged) is { } loss) silent.Add($"line {value + 1}: {loss}");
        }

        Assert.Empty(silent);
    }

    [Fact]
    public void The_damage_is_told_with_its_line()
    {
        List<string> lines = [.. Lines(Sample)];
        var head = lines.IndexOf("ENTITIES");
        lines.RemoveAt(head + 1);

        var finding = Assert.Single(Read(lines).Diagnostics, diagnostic => diagnostic.Id == "DXF0050");
        Assert.Equal(head + 2, finding.Source.Line);
        Assert.Contains("'LINE'", finding.Message, StringComparison.Ordinal);
    }

    /// <summary>Sections added by other programs, with special records; preview pictures; data that AutoCAD stores after the entities; header variables after
    /// the end of the header.</summary>
    [Theory]
    [InlineData("THUMBNAILIMAGE", "90 12|310 28000000|310 FFFF")]
    [InlineData("ACDSDATA", "70 2|71 6|0 ACDSSCHEMA|90 0|1 AcDb_Thumbnail_Schema|2 AcDbDs::ID|280 10|91 8|0 ACDSRECORD|90 0")]
    [InlineData("CLASSES", "0 CLASS|1 WIPEOUT|2 AcDbWipeout|3 ObjectDBX|90 127|280 0")]
    [InlineData("OBJECTS", "0 DICTIONARY|5 C|3 LINE|350 D|0 XRECORD|8 LINE|10 1|10 2|8 LINE")]
    [InlineData("ACME_STUFF", "0 FOO|8 LINE|10 1|0 BAR|2 ENTITIES")]
    public void Sections_of_other_programs_stay_quiet(string name, string pairs)
    {
        (int, object)[] content = [.. pairs.Split('|').Select(pair => pair.Split(' ', 2)).Select(pair => (int.Parse(pair[0], CultureInfo.InvariantCulture), (object)pair[1]))];
        var file = new DxfText().Header("AC1015", 4).Section("ENTITIES", Line).Section(name, content).End().ToAscii();

        Assert.Empty(DxfReading.Of(file).Diagnostics);
        Assert.Empty(CrossCheck.Read(file).DifferencesFrom(DrawingSummary.From(DxfReading.Of(file))));
    }

    [Fact]
    public void A_layer_that_is_called_like_an_entity_is_no_damage()
    {
        var file = new DxfText().Header("AC1015", 4)
            .Section("BLOCKS", (0, "BLOCK"), (8, "LINE"), (2, "B"), (0, "CIRCLE"), (8, "LINE"), (10, 0), (20, 0), (40, 1), (0, "ENDBLK"), (5, "1F"), (8, "LINE"))
            .Section("ENTITIES", (0, "TEXT"), (5, "1"), (8, "TEXT"), (10, 0), (20, 0), (40, 1), (1, "LINE"), (0, "INSERT"), (8, "INSERT"), (2, "B"), (10, 0), (20, 0)).End().ToAscii();

        Assert.Empty(DxfReading.Of(file).Diagnostics);
        Assert.Empty(CrossCheck.Read(file).DifferencesFrom(DrawingSummary.From(DxfReading.Of(file))));
    }

    /// <summary>Twelve offsets of each form of each sample: a sector of zeros is an error unless every curve is still read.</summary>
    [Fact]
    public void A_sector_of_zeros_is_never_passed_over_in_silence()
    {
        var random = new Random(11);
        var silent = new List<string>();
        foreach (var path in Directory.GetFiles(RepositoryFolder.Samples, "*.dxf").Order(StringComparer.Ordinal))
        {
            var file = File.ReadAllBytes(path);
            if (file.Length > 400_000 || file.AsSpan().StartsWith("AutoCAD Binary"u8)) continue;
            var whole = Curves(DxfReading.Of(file));
            foreach (var form in (byte[][])[file, Encoding.Unicode.GetBytes('\uFEFF' + Encoding.UTF8.GetString(file))])
            {
                for (var trial = 0; trial < 12; trial++)
                {
                    var sector = trial % 2 == 0 ? 4096 : 512;
                    var at = sector * random.Next((form.Length / sector) + 1);
                    byte[] damaged = [.. form];
                    damaged.AsSpan(at, Math.Min(sector, damaged.Length - at)).Clear();
                    var read = DxfReading.Of(damaged);
                    if (!read.HasErrors && Curves(read) != whole) silent.Add($"{Path.GetFileName(path)}, {sector} bytes at {at}");
                }
            }
        }

        Assert.Empty(silent);
    }

    [Theory]
    [InlineData("\0")]
    [InlineData("\0\0\0\0")]
    [InlineData("\n\0")]
    public void A_zero_byte_inside_the_text_is_an_error_with_its_line(string zeros)
    {
        var text = Encoding.UTF8.GetString(Sample.ToAscii());
        var at = text.IndexOf("CIRCLE", StringComparison.Ordinal) + "CIRCLE".Length;
        var line = text[..at].Count(c => c == '\n') + 1;

        var finding = Assert.Single(DxfReading.Of(text.Insert(at, zeros)).Diagnostics, diagnostic => diagnostic.Id == "DXF0054");
        Assert.Equal(zeros[0] == '\n' ? line + 1 : line, finding.Source.Line);
    }

    [Theory]
    [InlineData("\0\0\0")]
    [InlineData("\u001A")]
    [InlineData("\u001A\0\0\r\n\0")]
    [InlineData("\nanything \0 behind the end\n")]
    public void What_fills_up_the_end_of_the_file_is_no_damage(string tail)
    {
        var text = Encoding.UTF8.GetString(Sample.ToAscii()) + tail;

        Assert.Empty(DxfReading.Of(text).Diagnostics);
        Assert.Empty(DxfReading.Of(Encoding.Unicode.GetBytes('\uFEFF' + text)).Diagnostics);
    }

    private static (int, object)[] Insert(string block, double x) => [(0, "INSERT"), (5, "34"), (8, "CUT"), (2, block), (10, x), (20, 0.0)];

    private static string[] Lines(DxfText text) => Encoding.UTF8.GetString(text.ToAscii()).TrimEnd('\n').Split('\n');

    private static Drawing Read(IEnumerable<string> lines) => DxfReading.Of(Bytes(lines));

    private static byte[] Bytes(IEnumerable<string> lines) => Encoding.UTF8.GetBytes(string.Join('\n', lines) + "\n");

    /// <summary>The bytes of the skipped records, in the binary form.</summary>
    private static IEnumerable<int> FrameBytes(bool oneByteCodes)
    {
        var (at, inFrame) = (new DxfText().ToBinary(oneByteCodes).Length, false);
        foreach (var pair in Framed.Pairs)
        {
            var length = new DxfText().Add(pair).ToBinary(oneByteCodes).Length - new DxfText().ToBinary(oneByteCodes).Length;
            if (pair.Code == 0) inFrame = FrameTypes.Contains(pair.Value);
            for (var i = at; inFrame && i < at + length; i++) yield return i;
            at += length;
        }
    }

    private static string Types(Drawing drawing) => string.Join(' ', DxfReading.Curves(drawing).CountBy(entity => entity.Type).OrderBy(pair => pair.Key));

    /// <summary>The parts that were lost without an error, or without a difference in the second reader; null for none.</summary>
    private static string? Silence(IEnumerable<string> lines)
    {
        var file = Bytes(lines);
        var read = DxfReading.Of(file);
        if (Curves(read) == Curves(DxfReading.Of(Sample))) return null;
        if (!read.HasErrors) return $"the reader says {string.Join(' ', DxfReading.Ids(read))}";
        return CrossCheck.Read(file).DifferencesFrom(DrawingSummary.From(read)).Count == 0 ? "the second reading agrees" : null;
    }

    /// <summary>The cut curves, and whether their layers are switched on; in any order.</summary>
    private static string Curves(Drawing drawing)
    {
        var curves = DxfReading.Curves(drawing).Select(entity => string.Create(CultureInfo.InvariantCulture,
            $"{entity.Type} {drawing.Layers[entity.Layer].On} {string.Concat(Enumerable.Range(entity.FirstPart, entity.PartCount).Select(i => $"{drawing.Parts[i].A:R},{drawing.Parts[i].B:R},{drawing.Parts[i].D:R},{drawing.Parts[i].E:R};"))}"));
        return string.Join('\n', curves.Order(StringComparer.Ordinal)) + string.Concat(drawing.Layers.Select(layer => $"\n{layer.Name} {layer.On}").Order(StringComparer.Ordinal));
    }
}
