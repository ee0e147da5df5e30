using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Reshaping;

/// <summary>Perpendicular feet, tangents and polar directions compared with independent arithmetic.</summary>
public class SegmentFeetTests
{
    private static readonly Gen<Point2D> s_places = from x in Gen.Choose(-90_000, 90_000) from y in Gen.Choose(-90_000, 90_000) select new Point2D(x / 1000.0, y / 1000.0);

    private static readonly Arbitrary<(Segment Segment, Point2D From)> s_looks = (from segment in Gen.OneOf(Arcs.Any.Generator.Select(Segment.FromArc), FreeCurves.Ellipses.Generator.Select(Segment.FromCurve)) from place in s_places select (segment, place)).ToArbitrary();

    /// <summary>From 13,0 a circle of radius 5 is touched after 12 (5, 12, 13), at x = 25 / 13.</summary>
    [Fact]
    public void A_circle_is_touched_where_Pythagoras_says()
    {
        var touches = SegmentFeet.Tangent(Circle(5.0), new Point2D(13, 0)).ToList();

        Assert.Equal([25.0 / 13.0, 25.0 / 13.0], touches.Select(touch => Math.Round(touch.X, 12)), (a, b) => Math.Abs(a - b) < 1e-11);
        Assert.All(touches, touch => Assert.Equal(12.0, touch.DistanceTo(new Point2D(13, 0)), 12));
        Assert.Empty(SegmentFeet.Tangent(Circle(5.0), new Point2D(3, 0)));
        Assert.Empty(SegmentFeet.Tangent(Segment.FromLine(default, new Point2D(1, 0)), new Point2D(3, 1)));
    }

    [Fact]
    public void The_foot_on_a_line_may_lie_beyond_its_end_and_a_circle_has_two()
    {
        Assert.Equal([new Point2D(20, 0)], SegmentFeet.Perpendicular(Segment.FromLine(default, new Point2D(10, 0)), new Point2D(20, 7)));
        Assert.Equal([new Point2D(5, 0), new Point2D(-5, 0)], SegmentFeet.Perpendicular(Circle(5.0), new Point2D(13, 0)));
    }

    [Property(MaxTest = 2000, MaxRejected = 20_000)]
    public Property Lines_to_feet_are_square_and_to_tangent_places_touch() => Prop.ForAll(s_looks, look =>
    {
        var (segment, from) = look;
        var (feet, touches) = (SegmentFeet.Perpendicular(segment, from).ToList(), SegmentFeet.Tangent(segment, from).ToList());
        return Prop.When(feet.Count + touches.Count > 0, () =>
            feet.TrueForAll(foot => SegmentCrossings.IsOn(segment, foot) && Math.Abs((foot - from).Dot(TangentAt(segment, foot))) <= 1e-5 * (1.0 + foot.DistanceTo(from)))
            && touches.TrueForAll(touch => SegmentCrossings.IsOn(segment, touch) && Math.Abs((touch - from).Cross(TangentAt(segment, touch))) <= 1e-5 * (1.0 + touch.DistanceTo(from))));
    });

    /// <summary>A point on a whole ellipse just before its seam is at the end of the parameter, one just after it at the start.</summary>
    [Theory]
    [InlineData(0.9999)]
    [InlineData(0.99999)]
    [InlineData(0.00001)]
    [InlineData(0.0001)]
    public void A_place_near_the_seam_of_an_ellipse_is_found_on_its_side(double fraction)
    {
        var whole = Segment.FromCurve(FreeCurves.Ellipse(3, 4, 20, 0.4, 30, 0, 360).ToCurve());

        Assert.Equal(fraction, PathPlace.Nearest(0, whole, whole.PointAt(fraction)).Fraction, 9);
    }

    [Theory]
    [InlineData(45.0, 10.0, 9.8, 9.9, 9.9)]
    [InlineData(90.0, 0.3, -20.0, 0.0, -20.0)]
    [InlineData(30.0, 17.0, 10.0, 17.080127018922195, 9.861215932167728)]
    public void A_place_near_a_direction_is_drawn_onto_it(double step, double x, double y, double atX, double atY) =>
        Assert.True(PolarTrack.Find(default, new Point2D(x, y), step, 1.0)!.Value.IsNear(new Point2D(atX, atY), 1e-12));

    [Fact]
    public void A_place_too_far_beside_a_direction_stays()
    {
        Assert.Null(PolarTrack.Find(default, new Point2D(10, 7), 45.0, 1.0));
        Assert.Null(PolarTrack.Find(default, default, 45.0, 1.0));
    }

    private static Vector2D TangentAt(Segment segment, Point2D place) => segment.TangentAt(PathPlace.Nearest(0, segment, place).Fraction);

    private static Segment Circle(double radius) => Segment.FromArc(new ArcSegment(default, radius, Angle.Zero, Angle.FullTurn));
}
