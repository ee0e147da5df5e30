using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Dxf.Lengths;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.TestKit;
using Engraver.Tools.CrossChecks;

namespace Engraver.Core.Tests.Dxf;

/// <summary>The spans of arcs, ellipses and edges of hatches when their angles are rounded; none is lost silently.</summary>
public class SpanTests
{
    private const double HalfEllipse = 24.2211206; // half of the circumference with half-axes 10 and 5

    /// <summary>Radians as real files write them: eight decimals of 2 pi, three; several turns.</summary>
    [Theory]
    [InlineData(0.0, 6.28318531)]
    [InlineData(0.0, 6.284)]
    [InlineData(0.0, 6.28318530718)]
    [InlineData(1.5, 7.7831854)]
    [InlineData(0.0, 12.5664)]
    [InlineData(-3.14159265, 3.1415927)]
    public void An_ellipse_whose_end_is_rounded_up_is_whole(double start, double end)
    {
        var drawing = Read(Ellipse(start, end));

        Assert.Equal(2.0 * HalfEllipse, Length(drawing), 1e-5);
        Assert.True(drawing.Entities[0].Closed);
        Assert.Empty(drawing.Diagnostics);
    }

    [Theory]
    [InlineData(0.0, 360.000001, 360.0, "")]
    [InlineData(0.0, 360.05, 360.0, "")]
    [InlineData(90.0, 450.000001, 360.0, "")]
    [InlineData(0.0, 720.01, 360.0, "")]
    [InlineData(0.0, 360.06, 0.06, "DXF0059")]
    [InlineData(10.0, 420.0, 50.0, "DXF0059")]
    [InlineData(0.0, -400.0, 320.0, "DXF0059")]
    [InlineData(90.0, 90.000001, 0.000001, "")]
    [InlineData(359.9999, 0.0001, 0.0002, "")]
    [InlineData(0.0, 359.9999, 359.9999, "")]
    public void An_arc_up_to_a_thousandth_of_a_radian_beyond_whole_turns_is_one_turn(double start, double end, double sweep, string finding)
    {
        var drawing = Read(Arc(start, end));

        Assert.Equal(sweep, drawing.Parts[0].F, 1e-9);
        Assert.Equal(sweep == 360.0, drawing.Entities[0].Closed);
        Assert.Equal(finding, string.Join(' ', DxfReading.Ids(drawing)));
    }

    /// <summary>Also a flat elliptical edge: there one degree is a large change of the parameter.</summary>
    [Theory]
    [InlineData("2", 1)]
    [InlineData("2", 0)]
    [InlineData("3", 1)]
    [InlineData("3", 0)]
    public void An_edge_of_a_hatch_whose_end_is_rounded_up_is_whole(string kind, int counterClockwise)
    {
        var exact = Read(Hatch(kind, 360.0, counterClockwise));
        foreach (var end in (double[])[360.000001, 360.05])
        {
            var drawing = Read(Hatch(kind, end, counterClockwise));
            Assert.Equal(Length(exact), Length(drawing), 1e-9);
            Assert.Empty(drawing.Diagnostics);
        }

        Assert.Equal("DXF0059", string.Join(' ', DxfReading.Ids(Read(Hatch(kind, 400.0, counterClockwise)))));
    }

    /// <summary>In blocks, mirrored by a scale or by the extrusion, as text and in binary, and in the second reading.</summary>
    [Fact]
    public void A_rounded_turn_is_whole_wherever_it_is_written()
    {
        (int, object)[] curves = [.. Ellipse(0.0, 6.28318531), .. Arc(0.0, 360.000001), .. Arc(0.0, 360.000001), (230, -1.0)];
        var text = new DxfText().Header("AC1015", 4)
            .Section("BLOCKS", OddDrawings.Block("A", curves))
            .Section("ENTITIES", [.. curves, (0, "INSERT"), (2, "A"), (10, 0.0), (20, 0.0), (41, -1.0)])
            .End();

        foreach (var file in (byte[][])[text.ToAscii(), text.ToBinary(oneByteCodes: false), text.ToBinary(oneByteCodes: true)])
        {
            var drawing = DxfReading.Of(file);
            Assert.Equal(2.0 * ((2.0 * HalfEllipse) + (2.0 * Math.Tau * 10.0)), Length(drawing), 1e-5);
            Assert.Empty(drawing.Diagnostics);
            Assert.Empty(CrossCheck.Read(file).DifferencesFrom(DrawingSummary.From(drawing)));
        }
    }

    /// <summary>Angles that run clockwise by almost a turn end next to their start: whether a point or a whole ellipse was meant is ambiguous, and the operator
    /// must see it.</summary>
    [Theory]
    [InlineData(0.0, -6.28318530)]
    [InlineData(6.2831853, -1e-9)]
    public void A_span_that_shrinks_to_a_point_is_an_error_that_names_the_curve(double start, double end)
    {
        var finding = Assert.Single(Read([.. Ellipse(start, end), (5, "2A")]).Diagnostics, diagnostic => diagnostic.Id == "DXF0060");

        Assert.Equal("2A", finding.Source.Handle);
        Assert.Contains("48.", finding.Message, StringComparison.Ordinal);
    }

    /// <summary>The check must find losses of the mapping independent of their cause: here the mapping is replaced by one that draws almost nothing.</summary>
    [Theory]
    [InlineData("LINE")]
    [InlineData("CIRCLE")]
    [InlineData("ARC")]
    [InlineData("ELLIPSE")]
    [InlineData("SPLINE")]
    [InlineData("LWPOLYLINE")]
    public void A_curve_that_the_mapping_loses_is_found(string type)
    {
        var (record, shape) = (Record(type), new CurveShape());
        shape.Begin(CurveType.Line);
        var check = new LengthCheck(new LayerTable(new NameTable(bytes => "")));

        Assert.Equal("DXF0060", check.Find(record, shape)?.Rule.Id);
        shape.Add(DrawingPart.Line(0, 0.0, 0.0, 0.0, 1e-6, 0.0, 0.0));
        Assert.Equal("DXF0060", check.Find(record, shape)?.Rule.Id);
        shape.Add(DrawingPart.Line(0, 0.0, 0.0, 0.0, 1e-3, 0.0, 0.0));
        Assert.Null(check.Find(record, shape));
    }

    [Theory]
    [InlineData(60, 1)]
    [InlineData(8, "HIDDEN")]
    public void A_curve_that_is_not_visible_is_no_error(int code, object value)
    {
        var file = new DxfText().Header("AC1015", 4)
            .Section("TABLES", (0, "TABLE"), (2, "LAYER"), (0, "LAYER"), (2, "HIDDEN"), (70, 0), (62, -7), (0, "ENDTAB"))
            .Section("ENTITIES", [.. Ellipse(0.0, -6.28318530), (code, value)]).End();

        Assert.DoesNotContain("DXF0060", DxfReading.Ids(DxfReading.Of(file)));
    }

    internal static (int, object)[] Ellipse(double start, double end) => [(0, "ELLIPSE"), (10, 3.0), (20, 4.0), (11, 10.0), (21, 0.0), (40, 0.5), (41, start), (42, end)];

    internal static (int, object)[] Arc(double start, double end) => [(0, "ARC"), (10, 3.0), (20, 4.0), (40, 10.0), (50, start), (51, end)];

    internal static double Length(Drawing drawing) => Enumerable.Range(0, drawing.Parts.Count).Sum(part => drawing.SpaceLengthOf(drawing.Parts[part]));

    private static (int, object)[] Hatch(string kind, double end, int counterClockwise) =>
        [(0, "HATCH"), (91, 1), (92, 1), (93, 1), (72, kind), (10, 0.0), (20, 0.0), .. (kind == "2" ? [(40, 5.0)] : ((int, object)[])[(11, 10.0), (21, 0.0), (40, 0.01)]), (50, 0.0), (51, end), (73, counterClockwise), (97, 0), (75, 0)];

    private static Drawing Read((int, object)[] pairs) => DxfReading.Of(DxfText.WithEntities(pairs).ToAscii(), new DxfReadOptions(Cut: CutChoice.Hatch));

    /// <summary>A record of about 10 units.</summary>
    private static EntityRecord Record(string type)
    {
        var record = new EntityRecord();
        record.Begin(RecordKinds.Find(type), type, 0, 1, 0);
        (int Code, double Value)[] pairs = type is "SPLINE" or "LWPOLYLINE"
            ? [(10, 0.0), (20, 0.0), (10, 3.0), (20, 5.0), (10, 8.0), (20, 1.0)]
            : [(10, 0.0), (20, 0.0), (11, 8.0), (21, 3.0), (40, 0.6), (41, 0.0), (42, 2.0), (50, 0.0), (51, 90.0)];
        foreach (var (code, value) in pairs) record.Collect(code, type is "CIRCLE" or "ARC" && code == 40 ? 5.0 : value);
        return record;
    }
}
