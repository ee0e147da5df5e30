using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Pockets;
using Engraver.TestKit;
using static Engraver.Core.Tests.Offsets.OffsetShapes;

namespace Engraver.Core.Tests.Pockets;

/// <summary>Pockets whose passes and areas can be computed by hand.</summary>
public class AnalyticPocketTests
{
    [Theory]
    [InlineData(0.5, 10)]
    [InlineData(0.25, 19)]
    [InlineData(0.95, 5)]
    public void A_circle_is_cleared_by_circles_a_stepover_apart(double stepover, int passes)
    {
        var result = Plan(Options(1.0, stepover), Circle(3, 4, 10.5));

        Assert.Equal(passes, result.Passes.Count(pass => pass.Kind is PassKind.Wall or PassKind.Contour));
        Assert.All(result.Passes, pass => Assert.Equal(SegmentKind.Circle, Assert.Single(pass.Segments).Kind));
        IsNear(Math.PI * 10.5 * 10.5, result.ReachableArea);
        IsNear(result.ReachableArea, result.CoveredArea);
        Assert.Empty(result.Unreached);
        Assert.Single(result.Strokes);
    }

    [Theory]
    [InlineData(PocketStrategy.Contour)]
    [InlineData(PocketStrategy.Zigzag)]
    public void The_corners_of_a_rectangle_are_told_with_place_and_size(PocketStrategy strategy)
    {
        var result = Plan(Options(2.0, 0.5) with { Strategy = strategy }, Rectangle(10, 20, 30, 16));
        var corner = (4.0 - Math.PI) * 4.0;

        IsNear(corner, result.UnreachableArea);
        IsNear((30.0 * 16.0) - corner, result.CoveredArea);
        Assert.Equal([new Point2D(10, 20), new Point2D(10, 36), new Point2D(40, 20), new Point2D(40, 36)], result.Unreached.Select(place => place.Place).OrderBy(place => place.X).ThenBy(place => place.Y));
        Assert.All(result.Unreached, place => Assert.Equal(2.0 * (Math.Sqrt(2.0) - 1.0), place.Depth, 4));
        Assert.All(result.Unreached, place => Assert.Equal(corner / 4.0, place.Area!.Value, 6));
    }

    [Fact]
    public void A_slot_as_wide_as_the_tool_is_one_straight_pass()
    {
        var result = Plan(Options(3.0, 0.5), Slot(20, 3));

        var pass = Assert.Single(result.Passes);
        Assert.False(pass.Closed);
        Assert.Equal(20.0, pass.Segments.Sum(segment => segment.Length), 5);
        Assert.Equal(1.0, result.Coverage!.Value, 6);
        Assert.Empty(result.TooNarrow);
    }

    [Fact]
    public void A_ring_as_wide_as_the_tool_is_one_circle()
    {
        var result = Plan(Options(1.5, 0.5), Circle(0, 0, 10), Circle(0, 0, 7));

        var pass = Assert.Single(result.Passes);
        Assert.Equal(2.0 * Math.PI * 8.5, pass.Segments.Sum(segment => segment.Length), 4);
        Assert.Equal(1.0, result.Coverage!.Value, 6);
    }

    [Fact]
    public void A_wide_ring_is_cleared_without_a_lift()
    {
        var result = Plan(Options(1.0, 0.6), Circle(0, 0, 20), Circle(0, 0, 9.8));

        Assert.Single(result.Strokes);
        IsNear(Math.PI * (400.0 - (9.8 * 9.8)), result.CoveredArea);
    }

    /// <summary>A tool of 6 does not fit the neck of 4 between two rooms of 10: both rooms are cleared, and the neck is reported.</summary>
    [Fact]
    public void A_neck_that_is_too_narrow_is_told()
    {
        var dumbbell = Polygon((0, 0), (10, 0), (10, 4), (20, 4), (20, 0), (30, 0), (30, 10), (20, 10), (20, 8), (10, 8), (10, 10), (0, 10));
        var result = Plan(Options(2.5, 0.5), dumbbell);

        Assert.Equal(2, result.Strokes.Count);
        Assert.Contains(result.Unreached, place => place.Area > 30.0);
        IsNear(result.UnreachableArea, result.Unreached.Sum(place => place.Area!.Value), 1e-4);
    }

    [Fact]
    public void A_region_narrower_than_the_tool_is_told_with_its_width()
    {
        var result = Plan(Options(1.0, 0.5), Rectangle(0, 0, 20, 1.5), Circle(40, 0, 5));

        var narrow = Assert.Single(result.TooNarrow);
        Assert.Equal(1.5, narrow.Width, 5);
        Assert.Equal(0.75, narrow.Place.Y, 5);
        IsNear(Math.PI * 25.0, result.CoveredArea);
    }

    /// <summary>At a stepover of 1.9 radii concentric squares leave a sliver in every corner, which a separate pass removes.</summary>
    [Fact]
    public void Slivers_in_corners_are_cut()
    {
        var result = Plan(Options(1.0, 0.95), Rectangle(0, 0, 30, 30));

        Assert.True(result.Passes.Count(pass => pass.Kind == PassKind.Sliver) >= 4 * 7);
        Assert.Empty(result.LeftStanding);
        IsNear(result.ReachableArea, result.CoveredArea);
        Assert.Single(result.Strokes);
    }

    [Fact]
    public void An_allowance_is_taken_by_a_last_pass_along_the_wall()
    {
        var result = Plan(Options(1.0, 0.5) with { Allowance = 0.2 }, Rectangle(0, 0, 30, 20), Circle(15, 10, 3));

        var finish = result.Passes.Where(pass => pass.Kind == PassKind.Finish).ToList();
        Assert.Equal(2, finish.Count);
        Assert.Equal([false, true, true], result.Strokes.Select(stroke => stroke.IsFinish));
        IsNear(2.0 * (28.0 + 18.0), finish[0].Segments.Sum(segment => segment.Length));
        Assert.All(result.Passes.Where(pass => pass.Kind == PassKind.Wall).SelectMany(pass => pass.Segments), segment => Assert.True(segment.PointAt(0.5).X >= 1.2 - 1e-9));
        IsNear(result.ReachableArea, result.CoveredArea);
    }

    /// <summary>Climb milling with a right-hand tool: the wall on the right, so that the outer wall is cut counter-clockwise and an island clockwise.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void The_pocket_lies_on_the_left_of_every_pass(bool fromCentre)
    {
        var result = Plan(Options(1.0, 0.5) with { FromCentre = fromCentre }, Rectangle(0, 0, 30, 20), Circle(15, 10, 3));

        Assert.Equal([false, true], result.Passes.Where(pass => pass.Level == 0).Select(pass => ChainArea.Of(pass.Segments) < 0.0));
        var first = result.Strokes[0].Moves.Where(move => !move.IsLink).Select(move => move.Segment).ToList();
        var wall = fromCentre ? first[^1] : first[0];
        Assert.True(wall.Bounds.MinX <= 1.0 + 1e-9 || wall.Bounds.MaxX >= 29.0 - 1e-9 || wall.Bounds.MinY <= 1.0 + 1e-9 || wall.Bounds.MaxY >= 19.0 - 1e-9);
        Assert.True((wall.End - wall.Start).Cross(new Point2D(15, 10) - wall.Start) > 0.0);
    }

    [Fact]
    public void Nesting_makes_regions()
    {
        var result = Plan(Options(0.5, 0.5), Circle(0, 0, 20), Circle(0, 0, 15), Circle(0, 0, 10), Circle(50, 0, 4));

        Assert.Equal(3, result.Regions);
        IsNear(Math.PI * (400.0 - 225.0 + 100.0 + 16.0), result.CoveredArea);
    }

    [Fact]
    public void Rows_lie_at_the_angle_and_at_most_the_stepover_apart()
    {
        var result = Plan(Options(1.0, 0.7) with { Strategy = PocketStrategy.Zigzag, Angle = Angle.FromDegrees(30) }, Rectangle(0, 0, 40, 25));

        var rows = result.Passes.Where(pass => pass.Kind == PassKind.Row).Select(pass => pass.Segments[0]).ToList();
        Assert.All(rows, row => Assert.Equal(30.0, row.StartTangent.Direction.Degrees, 9));
        var across = new Vector2D(-0.5, Math.Sqrt(0.75));
        var places = rows.Select(row => across.Dot(row.Start - Point2D.Origin)).Order().ToList();
        Assert.All(places.Skip(1).Zip(places), pair => Assert.InRange(pair.First - pair.Second, 1.0, 1.4 + 1e-9));
        Assert.Single(result.Strokes);
    }

    [Fact]
    public void An_open_contour_is_counted_and_nothing_gives_nothing()
    {
        var result = Plan(Options(1.0, 0.5), Line((0, 0), (10, 0)));

        Assert.Equal((1, 0, 0), (result.WithoutInside, result.Regions, result.Passes.Count));
        Assert.Null(result.Coverage);
    }

    private static PocketOptions Options(double radius, double stepover) => UsualOptions.Pocket(radius, stepover);

    private static PocketResult Plan(PocketOptions options, params OffsetContour[] contours)
    {
        var result = PocketPlanner.Plan(contours, options);
        var fault = new PocketWitness(contours, options).Fault(result, 25);
        Assert.True(fault is null, fault);
        return result;
    }

    private static void IsNear(double expected, double actual, double relative = 1e-9) => Assert.InRange(actual, expected - (relative * (1.0 + Math.Abs(expected))), expected + (relative * (1.0 + Math.Abs(expected))));
}
