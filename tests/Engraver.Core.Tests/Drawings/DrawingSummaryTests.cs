using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Tests.Dxf;

namespace Engraver.Core.Tests.Drawings;

public class DrawingSummaryTests
{
    [Fact]
    public void Parts_of_polylines_count_as_lines_and_arcs_and_the_polyline_itself_once()
    {
        var summary = DrawingSummary.From(DxfReading.Entities(
            (0, "LINE"), (10, 0), (20, 0), (11, 3), (21, 4),
            (0, "CIRCLE"), (10, 0), (20, 0), (40, 1),
            (0, "LWPOLYLINE"), (70, 1), (10, 0), (20, 0), (10, 2), (20, 0), (42, 1),
            (0, "POINT")));

        Assert.Equal(new PrimitiveCounts(2, 1, 1, 0, 0, 1, 1), summary.Primitives);
        Assert.Equal((7.0, Math.PI, 2.0 * Math.PI), (summary.Length.Line, summary.Length.Arc, summary.Length.Circle));
        Assert.Equal("Line=1 Circle=1 LwPolyline=1", string.Join(' ', summary.Leaf.Select(entry => $"{entry.Key}={entry.Value}")));
    }

    [Fact]
    public void Lengths_in_space_and_in_plan_differ_by_the_climb()
    {
        var length = DrawingSummary.From(DxfReading.Entities((0, "LINE"), (10, 0), (20, 0), (30, 0), (11, 3), (21, 0), (31, 4))).Length;

        Assert.Equal((5.0, 3.0), (length.Total, length.PlanTotal));
    }

    [Fact]
    public void The_box_touches_the_true_extreme_of_an_arc()
    {
        var bounds = DrawingSummary.From(DxfReading.Entities((0, "ARC"), (10, 0), (20, 0), (40, 10), (50, 45), (51, 135))).Bounds!.Value;

        Assert.Equal(10.0, bounds.MaxY, 1e-12);
        Assert.Equal(10.0 * Math.Sqrt(0.5), bounds.MinY, 1e-12);
    }

    [Fact]
    public void Without_a_curve_there_is_no_box() => Assert.Null(DrawingSummary.From(DxfReading.Entities((0, "POINT"), (10, 5), (20, 5))).Bounds);

    [Fact]
    public void Hidden_curves_count()
    {
        var summary = DrawingSummary.From(DxfReading.Entities((0, "LINE"), (60, 1), (10, 0), (20, 0), (11, 3), (21, 0)));

        Assert.Equal(new Bounds2D(0, 0, 3, 0), summary.Bounds);
    }
}
