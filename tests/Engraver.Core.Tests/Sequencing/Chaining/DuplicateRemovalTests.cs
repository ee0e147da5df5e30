using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Tests.Sequencing.Chaining;

public class DuplicateRemovalTests
{
    private const double Tolerance = 0.001;

    [Fact]
    public void The_same_line_again_or_backwards_is_one_line_and_the_lower_row_stays() =>
        Assert.Equal([0, 2], DuplicateRemoval.Keep([Line(0, 0, 10, 0), Line(10, 0, 0, 0), Line(0, 1, 10, 1), Line(0.0005, 0, 10, 0)], Tolerance));

    [Fact]
    public void Beyond_the_tolerance_both_stay() =>
        Assert.Equal([0, 1], DuplicateRemoval.Keep([Line(0, 0, 10, 0), Line(0, 0.002, 10, 0.002)], Tolerance));

    [Fact]
    public void The_two_halves_of_a_circle_are_no_duplicates_but_a_half_drawn_twice_is() =>
        Assert.Equal([0, 1], DuplicateRemoval.Keep([Half(0, 180), Half(180, 180), Half(180, -180)], Tolerance));

    [Fact]
    public void A_line_and_an_arc_between_the_same_ends_are_no_duplicates() =>
        Assert.Equal([0, 1], DuplicateRemoval.Keep([Line(10, 0, -10, 0), Half(0, 180)], Tolerance));

    [Fact]
    public void A_line_whose_middle_touches_a_circle_is_no_duplicate_of_it() =>
        Assert.Equal([0, 1], DuplicateRemoval.Keep([Circle(5), Line(-5, -5, -5, 5)], Tolerance));

    [Fact]
    public void Small_arcs_over_one_chord_differ_by_their_height()
    {
        Segment[] arcs = [Over(bulge: 0.1), Over(bulge: 0.136)];

        Assert.Equal([0, 1], DuplicateRemoval.Keep(arcs, Tolerance));

        static Segment Over(double bulge) => Segment.FromArc(ArcSegment.FromBulge(new Point2D(0, 0), new Point2D(0.05, 0), bulge));
    }

    [Fact]
    public void Concentric_circles_differ_by_radius() =>
        Assert.Equal([0, 2], DuplicateRemoval.Keep([Circle(5), Circle(5), Circle(5.01)], Tolerance));

    /// <summary>Centre one tolerance to the right, radius two larger: the left quadrant points are one tolerance apart, the right ones three.</summary>
    [Fact]
    public void A_circle_that_lies_farther_than_the_tolerance_on_one_side_stays()
    {
        Assert.Equal([0, 1], DuplicateRemoval.Keep([At(0.0, 5.0), At(0.9 * Tolerance, 5.0 + (1.8 * Tolerance))], Tolerance));
        Assert.Equal([0], DuplicateRemoval.Keep([At(0.0, 5.0), At(0.4 * Tolerance, 5.0 + (0.5 * Tolerance))], Tolerance));

        static Segment At(double x, double radius) => Segment.FromArc(new ArcSegment(new Point2D(x, 0.0), radius, Angle.Zero, Angle.FullTurn));
    }

    [Fact]
    public void Tiny_steps_of_one_curve_are_no_duplicates() =>
        Assert.Equal(3, DuplicateRemoval.Keep([Line(0, 0, 0.0004, 0), Line(0.0004, 0, 0.0008, 0), Line(0.0008, 0, 0.0012, 0)], Tolerance).Length);

    private static Segment Line(double x1, double y1, double x2, double y2) => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2));

    private static Segment Half(double start, double sweep) =>
        Segment.FromArc(new ArcSegment(default, 10, Angle.FromDegrees(start), Angle.FromDegrees(sweep)));

    private static Segment Circle(double radius) => Segment.FromArc(new ArcSegment(default, radius, Angle.Zero, Angle.FullTurn));
}
