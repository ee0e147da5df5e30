using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Offsets;
using Engraver.Core.Sequencing;
using Engraver.Core.Tests.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Kerf;

/// <summary>A rectangle of 40 x 20 (entity 0), a hole of radius 5 in it (1), a line beside it (2), and their compensated paths.</summary>
public class KerfCompensationTests
{
    private static readonly (int, object)[] s_rectangle = [(0, "LWPOLYLINE"), (90, 4), (70, 1), (10, 0.0), (20, 0.0), (10, 40.0), (20, 0.0), (10, 40.0), (20, 20.0), (10, 0.0), (20, 20.0)];
    private static readonly (int, object)[] s_hole = [(0, "CIRCLE"), (10, 20.0), (20, 10.0), (40, 5.0)];
    private static readonly (int, object)[] s_line = [(0, "LINE"), (10, 60.0), (20, 0.0), (11, 60.0), (21, 20.0)];

    [Fact]
    public void By_nesting_the_outside_grows_and_the_hole_shrinks()
    {
        var kerf = Compensated(KerfSide.Nesting, 4.0, [.. s_rectangle, .. s_hole]);
        var segments = kerf.Table.ToSegments();

        Assert.Equal((9, 4, 4, 1), (segments.Length, Count(segments, SegmentKind.Line), Count(segments, SegmentKind.Arc), Count(segments, SegmentKind.Circle)));
        Assert.All(segments.Where(segment => segment.Kind == SegmentKind.Arc), segment => Assert.Equal(2.0, segment.Arc.Radius, 12));
        Assert.Equal(3.0, segments.Single(segment => segment.Kind == SegmentKind.Circle).Arc.Radius, 12);
        Assert.Equal((-2.0, -2.0, 42.0, 22.0), Box(segments));
        Assert.Empty(kerf.Diagnostics);
    }

    [Fact]
    public void Every_row_keeps_its_entity()
    {
        var table = Compensated(KerfSide.Nesting, 4.0, [.. s_rectangle, .. s_hole]).Table;

        Assert.Equal([0, 0, 0, 0, 0, 0, 0, 0, 1], Enumerable.Range(0, table.Count).Select(table.EntityIndexOf));
    }

    [Theory]
    [InlineData(KerfSide.Outside, -2.0, 42.0, 7.0)]
    [InlineData(KerfSide.Inside, 2.0, 38.0, 3.0)]
    public void Each_contour_by_itself(KerfSide side, double left, double right, double radius)
    {
        var segments = Compensated(side, 4.0, [.. s_rectangle, .. s_hole]).Table.ToSegments();
        var box = Box(segments);

        Assert.Equal((left, right), (box.MinX, box.MaxX));
        Assert.Equal(radius, segments.Single(segment => segment.Kind == SegmentKind.Circle).Arc.Radius, 12);
    }

    [Theory]
    [InlineData(KerfSide.Left, 58.0)]
    [InlineData(KerfSide.Right, 62.0)]
    public void Beside_an_open_line_in_its_direction(KerfSide side, double x)
    {
        var segment = Assert.Single(Compensated(side, 4.0, s_line).Table.ToSegments());

        Assert.Equal((new Point2D(x, 0.0), new Point2D(x, 20.0)), (segment.Start, segment.End));
    }

    /// <summary>Uncut by a round tool in a right angle: its radius times the root of 2 less 1, in each of four corners.</summary>
    [Fact]
    public void Corners_that_the_tool_does_not_reach_are_named_with_place_and_size()
    {
        var kerf = Compensated(KerfSide.Inside, 4.0, s_rectangle);

        Assert.Equal(["KRF0001", "KRF0001", "KRF0001", "KRF0001"], Ids(kerf));
        Assert.Equal([(0.0, 0.0), (0.0, 20.0), (40.0, 0.0), (40.0, 20.0)], kerf.Uncut.Select(place => (place.Place.X, place.Place.Y)).Order());
        Assert.All(kerf.Uncut, place => Assert.Equal(2.0 * (Math.Sqrt(2.0) - 1.0), place.Uncut, 12));
    }

    /// <summary>A gap between two parts that is narrower than the tool: both of its walls remain uncut, the rest of the outline is cut.</summary>
    [Fact]
    public void A_gap_that_is_too_narrow_is_named_too()
    {
        (int, object)[] beside = [(0, "LWPOLYLINE"), (90, 4), (70, 1), (10, 43.0), (20, 0.0), (10, 83.0), (20, 0.0), (10, 83.0), (20, 20.0), (10, 43.0), (20, 20.0)];
        var kerf = Compensated(KerfSide.Nesting, 4.0, [.. s_rectangle, .. beside]);

        Assert.Equal(["KRF0001", "KRF0001"], Ids(kerf));
        Assert.Equal([40.0, 43.0], kerf.Uncut.Select(place => place.Place.X).Order());
        Assert.All(kerf.Uncut, place => Assert.Equal(10.0, place.Place.Y, 0));
    }

    [Fact]
    public void A_hole_that_is_narrower_than_the_tool_is_an_error_and_the_rest_is_cut()
    {
        var kerf = Compensated(KerfSide.Nesting, 10.5, [.. s_rectangle, .. s_hole]);

        Assert.Equal(["KRF0003"], Ids(kerf));
        Assert.Equal(Severity.Error, kerf.Diagnostics[0].Severity);
        Assert.Equal(8, kerf.Table.Count);
    }

    [Fact]
    public void What_is_open_has_no_inside_and_is_cut_on_its_line()
    {
        var kerf = Compensated(KerfSide.Nesting, 4.0, [.. s_rectangle, .. s_line]);

        Assert.Equal(["KRF0004"], Ids(kerf));
        Assert.Contains(kerf.Table.ToSegments(), segment => segment.Start == new Point2D(60.0, 0.0) && segment.End == new Point2D(60.0, 20.0));
    }

    [Fact]
    public void A_contour_that_changes_its_height_is_not_compensated_where_heights_are_cut()
    {
        (int, object)[] tilted = [(0, "POLYLINE"), (66, 1), (70, 9), .. Vertex(0, 0, 0), .. Vertex(10, 0, 1), .. Vertex(10, 10, 1), .. Vertex(0, 10, 0), (0, "SEQEND")];

        Assert.Equal(["KRF0007"], Ids(Compensated(KerfSide.Nesting, 1.0, tilted, cutsHeights: true)));
        Assert.Empty(Compensated(KerfSide.Nesting, 1.0, tilted).Diagnostics);
    }

    /// <summary>A path that is not at its radius is found, with the distance and the position.</summary>
    [Fact]
    public void The_check_finds_a_path_at_another_distance()
    {
        OffsetContour drawn = new([Segment.FromArc(new ArcSegment(default, 5.0, Angle.Zero, Angle.FullTurn))], true);
        OffsetLoop wrong = new([Segment.FromArc(new ArcSegment(default, 7.1, Angle.Zero, Angle.FullTurn))], true) { Sources = [new OffsetSource(0, 0, IsJoin: false)] };

        Assert.Equal(0.1, new KerfCheck([drawn], [wrong], Options(KerfSide.Outside, 4.0, false)).MaxDeviation()!.Value.Distance, 9);
        Assert.Null(new KerfCheck([drawn], [wrong], Options(KerfSide.Outside, 4.2, false)).MaxDeviation());
    }

    private static (int, object)[] Vertex(double x, double y, double z) => [(0, "VERTEX"), (70, 32), (10, x), (20, y), (30, z)];

    private static KerfOptions Options(KerfSide side, double diameter, bool cutsHeights) => new(side, diameter, 0.001, 0.01, cutsHeights);

    private static KerfResult Compensated(KerfSide side, double diameter, (int, object)[] entities, bool cutsHeights = false)
    {
        var drawing = DxfReading.Entities(entities);
        var chained = Sequencer.Chain(ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, new LayerSelection([], []))), drawing, UsualOptions.Sequencing with { CutsHeights = cutsHeights });
        return KerfCompensation.Compensate(chained, Options(side, diameter, cutsHeights));
    }

    private static string[] Ids(KerfResult kerf) => [.. kerf.Diagnostics.Select(finding => finding.Id)];

    private static int Count(Segment[] segments, SegmentKind kind) => segments.Count(segment => segment.Kind == kind);

    private static (double MinX, double MinY, double MaxX, double MaxY) Box(Segment[] segments)
    {
        var box = segments.Aggregate(Bounds2D.Empty, (all, segment) => all.Union(segment.Bounds));
        return (Math.Round(box.MinX, 9), Math.Round(box.MinY, 9), Math.Round(box.MaxX, 9), Math.Round(box.MaxY, 9));
    }
}
