using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Unions;
using Engraver.TestKit;
using static Engraver.Core.Tests.Offsets.OffsetShapes;

namespace Engraver.Core.Tests.Unions;

public class ContourUnionTests
{
    private const double Tolerance = 1e-9;

    [Fact]
    public void Contours_that_do_not_touch_are_returned_as_given()
    {
        IReadOnlyList<Segment>[] given = [Square(0, 0, 2), RoundedRectangle(4, 3, 0.5).Segments.Select(segment => segment.Mapped(Transform2D.Move(new Vector2D(5, 0)))).ToArray(), Circle(20, 0, 3).Segments];
        var result = ContourUnion.Unite(given, Tolerance);
        Assert.True(result.IsComplete);
        Assert.Equal(3, result.Contours.Count);
        for (var i = 0; i < given.Length; i++) Assert.Same(given[i], result.Contours[i]);
    }

    [Fact]
    public void A_clockwise_outline_is_reversed_and_keeps_its_points()
    {
        var given = SeededUnions.Reversed(RoundedRectangle(4, 3, 0.5).Segments);
        var united = Assert.Single(ContourUnion.Unite([given], Tolerance).Contours);
        Assert.Equal(given.Select(segment => (segment.End, segment.Start)).Reverse(), united.Select(segment => (segment.Start, segment.End)));
        Assert.True(ChainArea.Of(united) > 0.0);
    }

    /// <summary>A letter o (hole in the opposite direction) and a badly drawn one (both in the same direction).</summary>
    [Fact]
    public void A_hole_remains_and_an_island_in_the_same_direction_vanishes()
    {
        IReadOnlyList<Segment> outline = Circle(0, 0, 5).Segments, hole = Circle(0, 0, 3, clockwise: true).Segments, island = Circle(0, 0, 3).Segments;
        Assert.Equal([outline, hole], ContourUnion.Unite([outline, hole], Tolerance).Contours);
        Assert.Equal([outline], ContourUnion.Unite([outline, island], Tolerance).Contours);
        Assert.Equal(Math.PI * 16.0, Area(ContourUnion.Unite([SeededUnions.Reversed(outline), SeededUnions.Reversed(hole)], Tolerance)), 12);
    }

    [Fact]
    public void A_filled_hole_in_a_ring_is_an_outline_again()
    {
        IReadOnlyList<Segment> outline = Square(0, 0, 9), hole = SeededUnions.Reversed(Square(1, 1, 7)), island = Square(2, 2, 5);
        Assert.Equal([outline, hole, island], ContourUnion.Unite([outline, hole, island], Tolerance).Contours);
    }

    [Fact]
    public void Overlapping_squares_have_one_outline()
    {
        var result = ContourUnion.Unite([Square(0, 0, 2), Square(1, 1, 2)], Tolerance);
        Assert.Equal(8, Assert.Single(result.Contours).Count);
        Assert.Equal(7.0, Area(result), 12);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Squares_with_a_common_edge_are_one_rectangle(bool isSecondReversed)
    {
        var second = isSecondReversed ? SeededUnions.Reversed(Square(2, 0, 2)) : Square(2, 0, 2);
        var result = ContourUnion.Unite([Square(0, 0, 2), second], Tolerance);
        Assert.Equal(8.0, Area(result), 12);
        if (!isSecondReversed) Assert.DoesNotContain(Assert.Single(result.Contours), segment => segment.Start.X == 2.0 && segment.End.X == 2.0);
    }

    [Fact]
    public void Common_parts_of_edges_disappear_however_long_they_are()
    {
        var result = ContourUnion.Unite([Square(0, 0, 4), Rectangle(4, 1, 2, 1).Segments, Rectangle(1, 4, 3, 2).Segments], Tolerance);
        Assert.Equal(16.0 + 2.0 + 6.0, Area(result), 12);
        Assert.Single(result.Contours);
    }

    [Fact]
    public void The_same_contour_twice_is_there_once()
    {
        Assert.Equal(4.0, Area(ContourUnion.Unite([Square(0, 0, 2), Square(0, 0, 2)], Tolerance)), 12);
        Assert.Equal(Math.PI, Area(ContourUnion.Unite([Circle(0, 0, 1).Segments, HalfCircles(), Circle(0, 0, 1).Segments], Tolerance)), 12);
    }

    [Fact]
    public void A_contour_and_its_reverse_cancel()
    {
        Assert.Empty(ContourUnion.Unite([Square(0, 0, 2), SeededUnions.Reversed(Square(0, 0, 2))], Tolerance).Contours);
        Assert.Empty(ContourUnion.Unite([Circle(0, 0, 1, clockwise: true).Segments, HalfCircles()], Tolerance).Contours);
    }

    [Fact]
    public void Arcs_on_one_circle_overlap()
    {
        IReadOnlyList<Segment> left = Chain(true, (0, 1, 1), (0, -1, 0)).Segments, upper = Chain(true, (1, 0, 1), (-1, 0, 0)).Segments;
        var result = ContourUnion.Unite([left, upper], Tolerance);
        Assert.Equal(0.75 * Math.PI, Area(result), 12);
        Assert.Single(result.Contours);
    }

    [Fact]
    public void Circles_that_touch_remain_as_they_are()
    {
        IReadOnlyList<Segment> one = Circle(0, 0, 1).Segments, outside = Circle(3, 0, 2).Segments, inside = Circle(-0.5, 0, 0.5).Segments;
        Assert.Equal([one, outside], ContourUnion.Unite([one, outside], Tolerance).Contours);
        Assert.Equal([one], ContourUnion.Unite([one, inside], Tolerance).Contours);
    }

    /// <summary>An S through the edge of a square, with its inflection on the edge: neither of its arcs crosses the edge.</summary>
    [Fact]
    public void A_contour_that_passes_through_an_edge_in_a_tangent_point_is_cut_there()
    {
        IReadOnlyList<Segment> bend = Chain(true, (-1, 1, Math.Tan(Math.PI / 8.0)), (0, 0, -Math.Tan(Math.PI / 8.0)), (1, -1, 0), (3, -1, 0), (3, 1, 0)).Segments;
        IReadOnlyList<Segment> square = Rectangle(-2, 0, 4, 4).Segments;
        var result = ContourUnion.Unite([square, bend], Tolerance);
        Assert.Null(new UnionWitness([square, bend]).Fault(result, 60));
        Assert.Single(result.Contours);
    }

    [Fact]
    public void Squares_that_meet_in_a_corner_are_separate_outlines()
    {
        var result = ContourUnion.Unite([Square(0, 0, 1), Square(1, 1, 1), Square(1, 0, 1), SeededUnions.Reversed(Square(1, 0, 1)), Square(0, 2, 1)], Tolerance);
        Assert.Equal(3, result.Contours.Count);
        Assert.All(result.Contours, contour => Assert.Equal(1.0, ChainArea.Of(contour), 12));
    }

    [Fact]
    public void Many_edges_through_one_point_are_united()
    {
        var blades = Enumerable.Range(0, 12).Select(i => SeededUnions.Mapped([Polygon((0, 0), (5, -0.5), (5, 0.5)).Segments], Transform2D.Rotate(Point2D.Origin, Angle.FromDegrees(30.0 * i)))[0]).ToArray();
        var result = ContourUnion.Unite(blades, Tolerance);
        Assert.Equal(12, result.Contours.Count);
        Assert.Equal(12 * 2.5, Area(result), 12);
    }

    [Fact]
    public void A_figure_of_eight_is_two_outlines()
    {
        var result = ContourUnion.Unite([Polygon((0, 0), (2, 2), (2, 0), (0, 2)).Segments], Tolerance);
        Assert.Equal(2, result.Contours.Count);
        Assert.Equal(2.0, Area(result), 12);
    }

    [Fact]
    public void A_pentagram_is_filled()
    {
        IReadOnlyList<Segment> pentagram = Polygon([.. Enumerable.Range(0, 5).Select(i => (Math.Cos(4.0 * Math.PI * i / 5.0), Math.Sin(4.0 * Math.PI * i / 5.0)))]).Segments;
        var result = ContourUnion.Unite([pentagram], Tolerance);
        Assert.Equal(10, Assert.Single(result.Contours).Count);
        Assert.Null(new UnionWitness([pentagram]).Fault(result, 60));
    }

    [Fact]
    public void A_spike_without_width_disappears()
    {
        var result = ContourUnion.Unite([Polygon((0, 0), (2, 0), (2, 1), (5, 1), (2, 1), (2, 2), (0, 2)).Segments, Polygon((9, 9), (8, 8)).Segments], Tolerance);
        Assert.Equal(4.0, ChainArea.Of(Assert.Single(result.Contours)), 12);
        Assert.All(result.Contours[0], segment => Assert.True(segment.End.X <= 2.0));
    }

    [Fact]
    public void Whole_segments_of_a_cut_contour_are_returned_as_given()
    {
        var given = RoundedRectangle(10, 6, 1).Segments;
        var united = Assert.Single(ContourUnion.Unite([given, Square(9.5, 2, 2)], Tolerance).Contours);
        Assert.Equal(given.Count - 1, united.Count(segment => given.Contains(segment)));
    }

    [Fact]
    public void An_open_contour_is_reported_and_does_not_affect_the_others()
    {
        IReadOnlyList<Segment> open = Line((0, 0), (5, 0), (5, 5)).Segments;
        var result = ContourUnion.Unite([open, Square(0, 0, 2), Square(1, 1, 2)], Tolerance);
        Assert.False(result.IsComplete);
        Assert.Equal([new Point2D(0, 0)], result.Unresolved);
        Assert.Same(open, result.Contours[0]);
        Assert.Equal(7.0, ChainArea.Of(result.Contours[1]), 12);
    }

    [Fact]
    public void Coordinates_that_are_not_numbers_are_reported()
    {
        IReadOnlyList<Segment> broken = Polygon((0, 0), (double.NaN, 1), (1, 1)).Segments;
        var result = ContourUnion.Unite([broken, Square(5, 5, 1)], Tolerance);
        Assert.Single(result.Unresolved);
        Assert.Equal(2, result.Contours.Count);
    }

    [Fact]
    public void No_contours_have_no_outlines()
    {
        Assert.Empty(ContourUnion.Unite([], Tolerance).Contours);
        Assert.Empty(ContourUnion.Unite([[]], Tolerance).Contours);
        Assert.True(ContourUnion.Unite([[]], Tolerance).IsComplete);
    }

    [Fact]
    public void Curves_and_a_tolerance_of_nothing_are_errors_of_the_caller()
    {
        var curve = new RationalCurve(SegmentKind.Spline, [new BezierSpan([0, 0, 0, 1, 1, 1, 0, 1, 0, 0, 0, 1])]);
        Assert.Throws<ArgumentException>(() => ContourUnion.Unite([[Segment.FromCurve(curve)]], Tolerance));
        Assert.Throws<ArgumentOutOfRangeException>(() => ContourUnion.Unite([], 0.0));
    }

    private static IReadOnlyList<Segment> Square(double x, double y, double size) => Rectangle(x, y, size, size).Segments;

    private static IReadOnlyList<Segment> HalfCircles() => Chain(true, (0, 1, 1), (0, -1, 1)).Segments;

    private static double Area(UnionResult result)
    {
        Assert.True(result.IsComplete);
        return result.Contours.Sum(ChainArea.Of);
    }
}
