using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;
using Engraver.TestKit;

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

    /// <summary>Chains, stars, circles, splines and pieces shorter than the tolerance, some of which are drawn again, reversed, or slightly moved.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void Rows_whose_ends_rule_it_out_need_not_be_compared(int seed)
    {
        const int Drawn = 300;
        var random = new Random(seed);
        var segments = new List<Segment>();
        while (segments.Count < Drawn) segments.Add(segments.Count > 0 && random.Next(4) == 0 ? Again(segments[random.Next(segments.Count)], random) : Random(random));
        var ends = new SegmentEnds([.. segments], 10 * Tolerance);
        var candidates = ends.MayCoincide([.. segments], Tolerance);

        var kept = DuplicateRemoval.Keep([.. segments], Tolerance);

        Assert.NotNull(candidates);
        Assert.InRange(candidates.Length, 1, Drawn - 1);
        Assert.InRange(kept.Length, 1, Drawn - 1);
        Assert.Equal(kept, DuplicateRemoval.Keep([.. segments], Tolerance, EndHeights.Flat, candidates));
    }

    [Fact]
    public void Ends_sought_within_less_than_the_tolerance_rule_nothing_out()
    {
        Segment[] twice = [Line(0, 0, 10, 0), Line(0, 0.0009, 10, 0.0009)];

        Assert.Null(new SegmentEnds(twice, Tolerance / 2.0).MayCoincide(twice, Tolerance));
    }

    private static Segment Random(Random random)
    {
        var (from, to) = (Place(random), Place(random));
        return random.Next(6) switch
        {
            0 => Segment.FromArc(ArcSegment.FromBulge(from, to + new Vector2D(0.5, 0.0), 0.4)),
            1 => Segment.FromArc(new ArcSegment(from, 1 + random.Next(3), Angle.Zero, Angle.FullTurn)),
            2 => Segment.FromCurve(FreeCurves.Spline(3, [from, from + new Vector2D(1, 2), to, to + new Vector2D(1, 1)], [1, 1, 1, 1])),
            3 => Segment.FromLine(from, from + new Vector2D(Tolerance * random.NextDouble(), 0.0)),
            _ => Segment.FromLine(from, to),
        };
    }

    /// <summary>A point of a coarse grid, so that many segments meet.</summary>
    private static Point2D Place(Random random) => new(random.Next(5), random.Next(5));

    private static Segment Again(Segment segment, Random random)
    {
        var aside = Transform2D.Move(new Vector2D(1.5 * Tolerance * random.NextDouble(), 0.0));
        return random.Next(3) switch { 0 => segment, 1 => segment.Reversed(), _ => segment.Mapped(aside) };
    }

    private static Segment Line(double x1, double y1, double x2, double y2) => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2));

    private static Segment Half(double start, double sweep) =>
        Segment.FromArc(new ArcSegment(default, 10, Angle.FromDegrees(start), Angle.FromDegrees(sweep)));

    private static Segment Circle(double radius) => Segment.FromArc(new ArcSegment(default, radius, Angle.Zero, Angle.FullTurn));
}
