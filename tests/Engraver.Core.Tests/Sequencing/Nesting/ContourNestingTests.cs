using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Nesting;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Sequencing.Nesting;

public class ContourNestingTests
{
    private const double Tolerance = 0.01;

    [Fact]
    public void Each_contour_knows_the_one_directly_around_it() =>
        Assert.Equal([-1, 0, 1, 0], InsideOf(new DrawingBuilder().Square(0, 0, 100).Square(10, 10, 40).Circle(30, 30, 5).Square(60, 60, 10)));

    [Fact]
    public void The_order_in_the_file_does_not_matter() =>
        Assert.Equal([1, 3, 3, -1], InsideOf(new DrawingBuilder().Circle(30, 30, 5).Square(10, 10, 40).Square(60, 60, 10).Square(0, 0, 100)));

    [Fact]
    public void An_open_contour_lies_inside_too_but_holds_nothing() =>
        Assert.Equal([-1, 0, 0], InsideOf(new DrawingBuilder().Square(0, 0, 100).Arc(50, 50, 20, 10, 350).Circle(50, 50, 2)));

    [Fact]
    public void Open_contours_before_and_between_the_closed_ones_confuse_nobody() =>
        Assert.Equal([-1, -1, 1, 1], InsideOf(new DrawingBuilder().Line(-50, -50, -60, -60).Square(0, 0, 100).Line(10, 10, 20, 20).Circle(50, 50, 2)));

    [Fact]
    public void An_arc_bulges_out_of_its_chord()
    {
        var halfDisc = new DrawingBuilder().Line(-10, 0, 10, 0).Arc(0, 0, 10, 0, 180);

        Assert.Equal([-1, 0, -1], InsideOf(halfDisc.Circle(0, 8, 1).Circle(8, 8, 1)));
    }

    [Fact]
    public void A_bite_out_of_a_square_is_outside()
    {
        var bitten = new DrawingBuilder().Line(0, 0, 20, 0).Line(20, 0, 20, 20).Line(20, 20, 0, 20)
            .Curve(CurveType.LwPolyline, Segment.FromArc(new ArcSegment(new Point2D(0, 10), 10, Angle.FromDegrees(90), Angle.FromDegrees(-180))));

        Assert.Equal([-1, -1, 0], InsideOf(bitten.Circle(4, 10, 1).Circle(15, 10, 1)));
    }

    [Fact]
    public void A_diamond_that_touches_its_square_at_every_corner_is_inside() =>
        Assert.Equal([-1, 0], InsideOf(new DrawingBuilder().Square(0, 0, 20).Line(10, 0.0, 20, 10).Line(20, 10, 10, 20).Line(10, 20, 0, 10).Line(0, 10, 10, 0)));

    [Fact]
    public void Equal_contours_do_not_hold_each_other() =>
        Assert.Equal([-1, -1], InsideOf(new DrawingBuilder().Circle(0, 0, 5).Circle(0, 0, 5)));

    [Fact]
    public void Neighbours_that_touch_are_side_by_side() =>
        Assert.Equal([-1, -1], InsideOf(new DrawingBuilder().Circle(0, 0, 5).Circle(9, 0, 4)));

    [Fact]
    public void A_line_that_is_mostly_outside_is_outside() =>
        Assert.Equal([-1, -1, 0], InsideOf(new DrawingBuilder().Circle(0, 0, 10).Line(6, 6, 9.9, 9.9).Line(-1, -1, -9, -9)));

    [Fact]
    public void A_figure_of_arcs_has_its_exact_area()
    {
        var right = new ArcSegment(new Point2D(5, 0), 1, Angle.FromDegrees(-90), Angle.FromDegrees(180));
        var left = new ArcSegment(new Point2D(0, 0), 1, Angle.FromDegrees(90), Angle.FromDegrees(180));
        Segment[] slot = [Line(0, -1, 5, -1), Segment.FromArc(right), Line(5, 1, 0, 1), Segment.FromArc(left)];

        Assert.Equal(10.0 + Math.PI, new ContourRegion(slot).SignedArea, 12);
        Assert.Equal(-10.0 - Math.PI, new ContourRegion([.. slot.Reverse().Select(segment => segment.Reversed())]).SignedArea, 12);
    }

    [Fact]
    public void A_vertex_on_the_ray_counts_once()
    {
        var diamond = new ContourRegion([Line(0, -1, 1, 0), Line(1, 0, 0, 1), Line(0, 1, -1, 0), Line(-1, 0, 0, -1)]);

        Assert.True(diamond.Contains(new Point2D(0, 0)));
        Assert.False(diamond.Contains(new Point2D(-1.5, 0)));
    }

    private static Segment Line(double x1, double y1, double x2, double y2) => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2));

    private static int[] InsideOf(DrawingBuilder drawing)
    {
        var segments = ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing.Build(), LayerSelection.Default)).ToSegments();
        return ContourNesting.Find(ContourChainer.Chain(segments, Tolerance).Contours, segments.ToArray(), Tolerance);
    }
}
