using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.TestKit;
using static Engraver.Core.Tests.Offsets.OffsetShapes;

namespace Engraver.Core.Tests.Offsets;

/// <summary>Offsets whose lines, arcs, length and area can be computed by hand.</summary>
public class AnalyticOffsetTests
{
    [Theory]
    [InlineData(OffsetSide.In, 2.0, 8.0)]
    [InlineData(OffsetSide.Out, 2.0, 12.0)]
    [InlineData(OffsetSide.In, 9.999999, 1e-6)]
    [InlineData(OffsetSide.Out, 1000.0, 1010.0)]
    public void A_circle_becomes_one_circle(OffsetSide side, double distance, double radius)
    {
        var loop = Assert.Single(Offset(distance, side, Circle(3, 4, 10)).Loops);

        Assert.Equal((0, 1), (loop.Lines, loop.Arcs));
        IsNear(Math.PI * radius * radius, loop.SignedArea);
        IsNear(2.0 * Math.PI * radius, loop.Length);
    }

    [Theory]
    [InlineData(10.0)]
    [InlineData(13.0)]
    [InlineData(20.0)]
    [InlineData(500.0)]
    public void Nothing_is_left_in_a_circle_at_its_radius_and_beyond(double distance) => Assert.Empty(Offset(distance, OffsetSide.In, Circle(0, 0, 10)).Loops);

    [Fact]
    public void A_rectangle_stays_one_inwards_and_has_round_corners_outwards()
    {
        var (inner, outer) = (Assert.Single(Offset(1, OffsetSide.In, Rectangle(0, 0, 10, 4)).Loops), Assert.Single(Offset(1, OffsetSide.Out, Rectangle(0, 0, 10, 4)).Loops));

        Assert.Equal((4, 0, 4, 4), (inner.Lines, inner.Arcs, outer.Lines, outer.Arcs));
        IsNear(16.0, inner.SignedArea);
        IsNear(40.0 + 28.0 + Math.PI, outer.SignedArea);
        IsNear(28.0 + (2.0 * Math.PI), outer.Length);
    }

    /// <summary>A line without an inside is at 0.4 of the offset at 1; two lines offset separately to the left are at 0.25 of one another.</summary>
    [Fact]
    public void What_took_no_part_in_an_offset_is_no_deviation_of_it()
    {
        var line = new OffsetContour([Segment.FromLine(new Point2D(2, 1.4), new Point2D(8, 1.4))], false);
        var beside = new OffsetContour([Segment.FromLine(new Point2D(0, 0.75), new Point2D(10, 0.75))], false);
        var below = new OffsetContour([Segment.FromLine(new Point2D(0, 0), new Point2D(10, 0))], false);

        Assert.InRange(ContourOffset.Offset([Rectangle(0, 0, 10, 4), line], 1, OffsetSide.In, UsualOptions.Offset).MaxDeviation, 0.0, 1e-9);
        Assert.InRange(ContourOffset.Offset([below, beside], 1, OffsetSide.Left, UsualOptions.Offset).MaxDeviation, 0.0, 1e-9);
        Assert.InRange(ContourOffset.Offset([Rectangle(0, 0, 10, 4), line], 1, OffsetSide.Both, UsualOptions.Offset).MaxDeviation, 0.0, 1e-9);
    }

    [Fact]
    public void Walls_exactly_two_distances_apart_leave_nothing_between_them()
    {
        Assert.Empty(Offset(2, OffsetSide.In, Rectangle(0, 0, 10, 4)).Loops);
        Assert.Empty(Offset(3, OffsetSide.In, Slot(20, 3)).Loops);
        var dumbbell = Polygon((0, 0), (10, 0), (10, 4), (20, 4), (20, 0), (30, 0), (30, 10), (20, 10), (20, 6), (10, 6), (10, 10), (0, 10));

        Assert.Equal([(5, 2), (5, 2)], Offset(1, OffsetSide.In, dumbbell).Loops.Select(loop => (loop.Lines, loop.Arcs)));
        Assert.Single(Offset(0.999, OffsetSide.In, dumbbell).Loops);
        Assert.Equal(2, Offset(1.001, OffsetSide.In, dumbbell).Loops.Count);
    }

    [Theory]
    [InlineData(1.0, 2, 2)]
    [InlineData(2.5, 2, 2)]
    public void A_slot_stays_a_slot(double distance, int lines, int arcs)
    {
        var loop = Assert.Single(Offset(distance, OffsetSide.In, Slot(20, 3)).Loops);

        Assert.Equal((lines, arcs), (loop.Lines, loop.Arcs));
        IsNear((20.0 * 2.0 * (3.0 - distance)) + (Math.PI * (3.0 - distance) * (3.0 - distance)), loop.SignedArea);
    }

    [Theory]
    [InlineData(1.0, 4)]
    [InlineData(4.0, 0)]
    [InlineData(5.0, 0)]
    public void Corners_of_a_rounded_rectangle_are_sharp_once_the_distance_is_their_radius(double distance, int arcs)
    {
        var loop = Assert.Single(Offset(distance, OffsetSide.In, RoundedRectangle(40, 20, 4)).Loops);
        var (width, height, radius) = (40.0 - (2.0 * distance), 20.0 - (2.0 * distance), Math.Max(0.0, 4.0 - distance));

        Assert.Equal((4, arcs), (loop.Lines, loop.Arcs));
        IsNear((width * height) - ((4.0 - Math.PI) * radius * radius), loop.SignedArea);
    }

    /// <summary>Outwards: the polygon's area, its length times the distance, and a sector for every convex corner; the concave corners are trimmed by tan of
    /// half their turn.</summary>
    [Fact]
    public void A_star_has_an_arc_at_every_tip_outwards()
    {
        var star = Star(5, 20, 8);
        var (area, length) = (ChainArea.Of(star.Segments), star.Segments.Sum(segment => segment.Length));
        var turns = star.Segments.Zip(star.Segments.Skip(1).Append(star.Segments[0]), (before, after) => before.EndTangent.TurnTo(after.StartTangent).Radians).ToArray();
        var loop = Assert.Single(Offset(0.5, OffsetSide.Out, star).Loops);

        Assert.Equal((10, 5), (loop.Lines, loop.Arcs));
        IsNear(area + (0.5 * length) + (0.25 * turns.Sum(turn => turn > 0.0 ? turn / 2.0 : Math.Tan(turn / 2.0))), loop.SignedArea);
    }

    [Fact]
    public void A_gear_keeps_its_arcs()
    {
        var loop = Assert.Single(Offset(0.25, OffsetSide.Out, Gear(12, 16, 20)).Loops);

        Assert.Equal((24, 48), (loop.Lines, loop.Arcs));
        Assert.Equal(12, loop.Segments.Count(segment => segment.Kind == SegmentKind.Arc && Math.Abs(segment.Arc.Radius - 20.25) < 1e-12));
        Assert.Equal(12, loop.Segments.Count(segment => segment.Kind == SegmentKind.Arc && Math.Abs(segment.Arc.Radius - 16.25) < 1e-12));
    }

    [Fact]
    public void Islands_grow_and_join_the_border_inwards()
    {
        var apart = Offset(0.5, OffsetSide.In, Rectangle(0, 0, 20, 20), Rectangle(15, 10, 2, 2));
        var joined = Assert.Single(Offset(1.6, OffsetSide.In, Rectangle(0, 0, 20, 20), Rectangle(15, 10, 2, 2)).Loops);

        Assert.Equal([false, true], apart.Loops.Select(loop => loop.IsHole));
        IsNear(361.0 - (4.0 + 4.0 + (0.25 * Math.PI)), apart.Loops.Sum(loop => loop.SignedArea));
        Assert.True(joined.SignedArea > 0.0);
    }

    [Fact]
    public void Outwards_islands_shrink_until_nothing_is_left_of_them()
    {
        var nearly = Offset(0.9, OffsetSide.Out, Rectangle(0, 0, 20, 20), Rectangle(9, 9, 2, 2));

        Assert.Equal([false, true], nearly.Loops.Select(loop => loop.IsHole));
        IsNear(0.04, -nearly.Loops[1].SignedArea);
        Assert.Single(Offset(1.0, OffsetSide.Out, Rectangle(0, 0, 20, 20), Rectangle(9, 9, 2, 2)).Loops);
        Assert.Single(Offset(1.1, OffsetSide.Out, Rectangle(0, 0, 20, 20), Rectangle(9, 9, 2, 2)).Loops);
    }

    [Fact]
    public void Two_parts_that_come_too_near_to_each_other_become_one()
    {
        var loop = Assert.Single(Offset(1.0, OffsetSide.Out, Circle(0, 0, 5), Circle(11, 0, 5)).Loops);
        var half = Math.Acos(5.5 / 6.0);

        Assert.Equal(2, loop.Arcs);
        IsNear(36.0 * ((2.0 * Math.PI) - (2.0 * half) + Math.Sin(2.0 * half)), loop.SignedArea);
        Assert.Equal(2, Offset(0.5, OffsetSide.Out, Circle(0, 0, 5), Circle(11, 0, 5)).Loops.Count);
    }

    [Theory]
    [InlineData(OffsetSide.Left, 18.0)]
    [InlineData(OffsetSide.Right, 20.0 + (Math.PI / 2.0))]
    public void An_open_contour_has_a_left_and_a_right(OffsetSide side, double length)
    {
        var loop = Assert.Single(Offset(1, side, Line((0, 0), (10, 0), (10, 10))).Loops);

        Assert.False(loop.Closed);
        IsNear(length, loop.Length);
        Assert.Equal(side == OffsetSide.Left ? 1.0 : -1.0, loop.Segments[0].Start.Y);
        Assert.Equal(0.0, loop.Segments[0].Start.X);
    }

    [Fact]
    public void Left_of_a_clockwise_contour_is_outside()
    {
        IsNear(Math.PI * 64, Area(OffsetSide.Left, clockwise: false));
        IsNear(Math.PI * 144, Area(OffsetSide.Left, clockwise: true));
        IsNear(Math.PI * 144, Area(OffsetSide.Right, clockwise: false));
        IsNear(Math.PI * 64, Area(OffsetSide.Right, clockwise: true));

        static double Area(OffsetSide side, bool clockwise) => Math.Abs(Assert.Single(Offset(2, side, Circle(0, 0, 10, clockwise)).Loops).SignedArea);
    }

    [Fact]
    public void Open_contours_have_no_inside()
    {
        var result = Offset(1, OffsetSide.In, Line((20, 0), (30, 0)), Circle(0, 0, 5));

        Assert.Single(result.Loops);
        Assert.Equal(1, result.WithoutInside);
    }

    [Fact]
    public void Both_is_in_and_out_of_what_is_closed_and_left_and_right_of_what_is_open()
    {
        var result = Offset(1, OffsetSide.Both, Line((20, 0), (30, 0)), Circle(0, 0, 5));

        Assert.Equal([true, true, false, false], result.Loops.Select(loop => loop.Closed));
        Assert.Equal([4.0 * 4.0 * Math.PI, 6.0 * 6.0 * Math.PI], result.Loops.Take(2).Select(loop => loop.SignedArea), (expected, found) => Math.Abs(expected - found) < 1e-9);
    }

    private static OffsetResult Offset(double distance, OffsetSide side, params OffsetContour[] contours)
    {
        var result = ContourOffset.Offset(contours, distance, side, UsualOptions.Offset);
        Assert.True(result.MaxDeviation < 1e-9, $"deviation {result.MaxDeviation}");
        Assert.Null(new OffsetWitness(contours).FaultOfLoops(result, distance));
        return result;
    }

    private static void IsNear(double expected, double found) => Assert.True(Math.Abs(expected - found) <= 1e-9 * Math.Max(Math.Abs(expected), 1e-3), $"{found:R} instead of {expected:R}");
}
