using System.Text;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

public class DxfDiagnosticTests
{
    private static readonly (int, object)[] Line = [(0, "LINE"), (10, 0), (20, 0), (11, 1), (21, 0)];

    private static readonly (int, object)[] Spline = [(0, "SPLINE"), (71, 3), (10, 0), (20, 0), (10, 1), (20, 2), (10, 3), (20, 2), (10, 4), (20, 0)];

    /// <summary>The smallest file that shows each rule.</summary>
    private static readonly Dictionary<string, byte[]> Cases = new()
    {
        ["DXF0001"] = [],
        ["DXF0002"] = "Dear Sir or Madam,\n"u8.ToArray(),
        ["DXF0003"] = new DxfText().Section("ENTITIES", Line).End().ToAscii(),
        ["DXF0004"] = "AC1015\0\0\0\0\0\u0001"u8.ToArray(),
        ["DXF0005"] = new DxfText().Section("ENTITIES", Line).ToAscii(),
        ["DXF0006"] = Encoding.ASCII.GetBytes("0\nSECTION\n2\nENTITIES\n0\nLINE\nabc\nxyz\n10\n0\n0\nENDSEC\n0\nEOF\n"),
        ["DXF0007"] = Entities((0, "LINE"), (10, "wide"), (20, 0), (11, 1), (21, 0)),
        ["DXF0008"] = Entities((0, "LINE"), (10, 0), (11, 1), (21, 0)),
        ["DXF0009"] = Entities([.. Line, (10, 777)]),
        ["DXF0010"] = Entities((0, "LINE"), (10, 1), (20, 0), (11, 1), (21, 0)),
        ["DXF0011"] = Entities((0, "CIRCLE"), (10, 1), (20, 0), (40, -1)),
        ["DXF0012"] = Entities((0, "BODY")),
        ["DXF0014"] = Entities((0, "CIRCLE"), (10, 1), (20, 0), (40, 1), (220, 1), (230, 1)),
        ["DXF0016"] = Entities((0, "POLYLINE"), (70, 64), (0, "VERTEX"), (10, 0), (20, 0), (0, "SEQEND")),
        ["DXF0017"] = Entities((0, "INSERT"), (2, "nowhere"), (10, 0), (20, 0)),
        ["DXF0018"] = Inserting([.. Line, (0, "INSERT"), (2, "B"), (10, 0), (20, 0)], (0, "INSERT"), (2, "B"), (10, 0), (20, 0)),
        ["DXF0019"] = Inserting(Line, (0, "INSERT"), (2, "B"), (10, 0), (20, 0), (70, 32767), (71, 32767)),
        ["DXF0021"] = Entities([.. Spline, (40, 0), (40, 0)]),
        ["DXF0022"] = Entities([(0, "POLYLINE"), (0, "VERTEX"), (10, 0), (20, 0), (0, "VERTEX"), (10, 1), (20, 0), .. Line]),
        ["DXF0023"] = Entities((0, "VERTEX"), (10, 0), (20, 0)),
        ["DXF0024"] = Entities((0, "LWPOLYLINE"), (43, 2), (10, 0), (20, 0), (10, 1), (20, 0)),
        ["DXF0025"] = Entities((0, "CIRCLE"), (10, 1), (20, 0), (40, 1), (230, 0)),
        ["DXF0026"] = Inserting([(0, "BODY")], (0, "INSERT"), (2, "B"), (10, 0), (20, 0)),
        ["DXF0027"] = Entities([.. Spline, (40, 0), (40, 0), (40, 0), (40, 0), (40, 1), (40, 1), (40, 1), (40, 1), (41, 1), (41, 0), (41, 0), (41, 1)]),
        ["DXF0028"] = Foreign(),
        ["DXF0029"] = Entities([.. Enumerable.Repeat<(int, object)>((0, "BODY"), 101)]),
        ["DXF0030"] = Entities((0, "LWPOLYLINE"), (90, 2_000_000_000), (10, 0), (20, 0), (10, 1), (20, 0)),
        ["DXF0031"] = Encoding.ASCII.GetBytes("0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n10\n0\n20\n0\n40\n12"),
        ["DXF0032"] = new DxfText().Add((0, "SECTION"), (2, "ENTITIES")).Add(Line).End().ToAscii(),
        ["DXF0033"] = Inserting([(0, "LINE"), (10, 1e60), (20, 0), (11, 1), (21, 0)], (0, "INSERT"), (2, "B"), (10, 0), (20, 0), (41, 1e60)),
        ["DXF0034"] = Entities((0, "SPLINE"), (71, 3), (10, 1), (20, 0)),
        ["DXF0035"] = new DxfText().Section("BLOCKS", (0, "BLOCK"), (2, "B"), (0, "ENDBLK"), (0, "BLOCK"), (2, "b"), (0, "ENDBLK")).End().ToAscii(),
        ["DXF0036"] = new DxfText().Section("HEADER", (9, "$DWGCODEPAGE"), (3, "KLINGON")).End().ToAscii(),
        ["DXF0037"] = Entities((0, "LINE"), (10, "1,5"), (20, 0), (11, 1), (21, 0)),
        ["DXF0038"] = Entities((0, "HATCH"), (91, 0)),
        ["DXF0039"] = Inserting([(0, "TEXT"), (10, 0), (20, 0), (40, 1), (1, "x")], (0, "INSERT"), (2, "B"), (10, 0), (20, 0), (70, 32767), (71, 32767)),
        ["DXF0040"] = "%PDF-1.7\n"u8.ToArray(),
        ["DXF0041"] = Entities((0, "SPLINE"), (71, 3), (11, 1), (21, 0), (11, 2), (21, 2), (11, 5), (21, 0)),
        ["DXF0042"] = new DxfText().Header("AC1015", 4).Add(Line).End().ToAscii(),
        ["DXF0043"] = new DxfText().Header("AC1015", 4).Section("BLOCKS", OddDrawings.Block("*Model_Space", Line)).End().ToAscii(),
        ["DXF0044"] = new DxfText().Header("AC1015", 4).Section("ENTITIES", Line).Section("OBJECTS", (0, "THING"), (2000, "x")).End().ToBinary(oneByteCodes: false),
        ["DXF0050"] = Encoding.ASCII.GetBytes("0\nSECTION\n2\nENTITIES\nLINE\n8\n0\n10\n0\n0\nENDSEC\n0\nEOF\n"),
        ["DXF0051"] = Entities([.. Line, (8, "0"), (8, "CIRCLE"), (8, "0"), (10, 5), (20, 5), (40, 1)]),
        ["DXF0052"] = new DxfText().Header("AC1015", 4).Section("ENTITIE5", Line).End().ToAscii(),
        ["DXF0053"] = Encoding.ASCII.GetBytes("0\nSECTION\n2\nOBJECTS\n0\nXRECORD\nabc\nxyz\n10\n0\n0\nENDSEC\n0\nEOF\n"),
        ["DXF0054"] = Encoding.ASCII.GetBytes("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\0\0\n20\n0\n11\n1\n21\n0\n0\nENDSEC\n0\nEOF\n"),
        ["DXF0055"] = Inserting(Line, (0, "INSERT"), (2, "B"), (10, 0), (20, 0), (41, 0)),
        ["DXF0056"] = Entities([.. Spline, (40, 0), (40, 0), (40, 0), (40, 0), (40, 1), (40, 1), (40, 1), (40, 1), (41, 1), (41, 1e9), (41, 1), (41, 1)]),
        ["DXF0058"] = Entities([(0, "LIN3"), .. Line[1..]]),
        ["DXF0059"] = Entities((0, "ARC"), (10, 1), (20, 0), (40, 1), (50, 0), (51, 400)),
        ["DXF0060"] = Entities((0, "ELLIPSE"), (10, 1), (20, 0), (11, 1), (21, 0), (40, 0.5), (41, 0), (42, "-6.28318530")),
        ["DXF0061"] = [.. "AutoCAD Binary DXF\n"u8, 0x1A, 0, 0, (byte)'S', 0],
        ["DXF0062"] = Entities([.. Line, (67, 1)]),
        ["DXF0063"] = Dashed("DASHED", "BYLAYER", Line),
        ["DXF0057"] = new DxfText().Header("AC1015", 4).Section("BLOCKS", Line).End().ToAscii(),
    };

    private static byte[] Dashed(string ofLayer, string ofCurve, params (int, object)[] entity) => new DxfText().Header("AC1015", 4)
        .Section("TABLES", (0, "TABLE"), (2, "LTYPE"), (0, "LTYPE"), (2, "CONTINUOUS"), (70, 0), (72, 65), (73, 0), (40, 0.0), (0, "LTYPE"), (2, "DASHED"), (70, 0), (72, 65), (73, 2), (40, 0.75), (49, 0.5), (49, -0.25), (0, "ENDTAB"),
            (0, "TABLE"), (2, "LAYER"), (0, "LAYER"), (2, "0"), (70, 0), (62, 7), (6, ofLayer), (0, "LAYER"), (2, "off"), (70, 0), (62, -7), (6, "DASHED"), (0, "ENDTAB"))
        .Section("ENTITIES", [.. entity, (6, ofCurve)]).End().ToAscii();

    /// <summary>By its own linetype or by its layer's, once for any number of entities, and not if it is not cut.</summary>
    [Theory]
    [InlineData("DASHED", "BYLAYER", "0", 1)]
    [InlineData("DASHED", "ByLayer", "0", 1)]
    [InlineData("CONTINUOUS", "dashed", "0", 1)]
    [InlineData("DASHED", "CONTINUOUS", "0", 0)]
    [InlineData("CONTINUOUS", "BYLAYER", "off", 0)]
    public void A_curve_with_gaps_in_its_linetype_says_that_they_are_cut_through(string ofLayer, string ofCurve, string layer, int findings)
    {
        var drawing = DxfReading.Of(Dashed(ofLayer, ofCurve, [(0, "LINE"), (8, layer), (6, ofCurve), (10, 0), (20, 0), (11, 1), (21, 0), (0, "LINE"), (8, layer), (10, 5), (20, 0), (11, 6), (21, 0)]));

        Assert.Equal(2, drawing.Entities.Count);
        Assert.Equal(findings, drawing.Diagnostics.Count(finding => finding.Id == "DXF0063"));
    }

    [Theory]
    [InlineData("\n")]
    [InlineData("\r\r\n")]
    [InlineData("\r")]
    public void A_binary_file_whose_line_ends_were_converted_is_named(string lineEnd) =>
        Assert.Equal("DXF0061", Assert.Single(DxfReading.Of([.. "AutoCAD Binary DXF"u8, .. Encoding.ASCII.GetBytes(lineEnd), 0x1A, 0, 0, 0, .. "SECTION"u8, 0]).Diagnostics).Id);

    [Fact]
    public void Paper_space_is_told_only_where_model_space_is_empty()
    {
        Assert.Contains("2 entities", Assert.Single(DxfReading.Of(Entities([.. Line, (67, 1), .. Line, (67, 1), (0, "VIEWPORT"), (67, 1)])).Diagnostics, finding => finding.Id == "DXF0062").Message, StringComparison.Ordinal);
        Assert.DoesNotContain(DxfReading.Of(Entities([.. Line, .. Line, (67, 1)])).Diagnostics, finding => finding.Id == "DXF0062");
        Assert.DoesNotContain(DxfReading.Of(Entities((0, "VIEWPORT"), (67, 1))).Diagnostics, finding => finding.Id == "DXF0062");
    }

    public static TheoryData<string> Ids => [.. DxfRules.All.Select(rule => rule.Id)];

    [Theory]
    [MemberData(nameof(Ids))]
    public void Every_rule_has_a_file_that_shows_it(string id)
    {
        var found = DxfReading.Of(Cases[id], new DxfReadOptions(Cut: CutChoice.Hatch)).Diagnostics.First(diagnostic => diagnostic.Id == id);

        Assert.DoesNotContain('?', found.Message);
        Assert.DoesNotContain('{', found.Message);
    }

    [Fact]
    public void Ids_are_unique_and_in_order() => Assert.Equal(DxfRules.All.Select(rule => rule.Id).Distinct().Order(), DxfRules.All.Select(rule => rule.Id));

    /// <summary>Line breaks are kept, so that the start of the file can be recognised.</summary>
    [Fact]
    public void The_beginning_of_another_file_is_shown_in_one_line_as_it_reads() =>
        Assert.Contains("'Dear Sir or Madam, thi'", Assert.Single(DxfReading.Of("Dear Sir\r\nor Madam,\n\nthis is not what you think\n").Diagnostics).Message, StringComparison.Ordinal);

    [Theory]
    [InlineData(41)]
    [InlineData(42)]
    public void An_insert_of_scale_0_says_so(int code)
    {
        var finding = Assert.Single(DxfReading.Of(Inserting(Line, (0, "INSERT"), (5, "2A"), (2, "B"), (10, 0), (20, 0), (code, 0))).Diagnostics, diagnostic => diagnostic.Id == "DXF0055");

        Assert.Equal("2A", finding.Source.Handle);
        Assert.Contains("group " + code, finding.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_sound_drawing_has_no_diagnostics() => Assert.Empty(DxfReading.Entities(Line).Diagnostics);

    [Fact]
    public void Refusals_beyond_a_hundred_are_summed_up_but_all_are_on_the_balance_sheet()
    {
        var drawing = DxfReading.Of(Entities([.. Enumerable.Repeat<(int, object)>((0, "BODY"), 5000)]));

        Assert.Equal((5000, 101), (drawing.Balance.Refused.Count, drawing.Diagnostics.Count));
        Assert.Contains("5000 times", drawing.Diagnostics[^1].Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_finding_says_type_place_and_handle()
    {
        var finding = Assert.Single(DxfReading.Entities((0, "BODY"), (5, "2F")).Diagnostics);

        Assert.Equal((19L, "2F"), (finding.Source.Line, finding.Source.Handle));
        Assert.StartsWith("BODY at line 19 ", finding.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Reading_can_be_cancelled() =>
        Assert.Throws<OperationCanceledException>(() => DxfReader.Read(Entities(Line), "x", DxfReadOptions.Default, new CancellationToken(canceled: true)));

    private static byte[] Entities(params ReadOnlySpan<(int, object)> pairs) => DxfText.WithEntities(pairs).ToAscii();

    private static byte[] Inserting(ReadOnlySpan<(int, object)> content, params ReadOnlySpan<(int, object)> entities) => new DxfText()
        .Header("AC1015", 4).Section("BLOCKS", [(0, "BLOCK"), (2, "B"), .. content, (0, "ENDBLK")]).Section("ENTITIES", entities).End().ToAscii();

    /// <summary>UTF-8 is declared by the version, the layer name is Latin-1.</summary>
    private static byte[] Foreign() => Encoding.Latin1.GetBytes(Encoding.UTF8.GetString(
        new DxfText().Header("AC1024", 4).Section("ENTITIES", [.. Line, (8, "Grösse")]).End().ToAscii()));
}
