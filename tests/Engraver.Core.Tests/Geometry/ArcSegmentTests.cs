using Engraver.Core.Geometry;

namespace Engraver.Core.Tests.Geometry;

public class ArcSegmentTests
{
    private static readonly ArcSegment s_upperHalf = new(new Point2D(100, 150), 50, Angle.Zero, Angle.FromDegrees(180));

    [Fact]
    public void Ends_of_the_papers_arc_are_whole_numbers()
    {
        Assert.Equal(new Point2D(150, 150), s_upperHalf.StartPoint);
        Assert.Equal(new Point2D(50, 150), s_upperHalf.EndPoint);
    }

    [Fact]
    public void The_box_reaches_the_quadrant_points_that_the_sweep_passes() => Assert.Equal(new Bounds2D(50, 150, 150, 200), s_upperHalf.Bounds);

    [Fact]
    public void The_box_of_a_clockwise_arc_is_that_of_the_same_arc_reversed()
    {
        var arc = new ArcSegment(new Point2D(1, 2), 3, Angle.FromDegrees(350), Angle.FromDegrees(-200));

        Assert.Equal(arc.Bounds, arc.Reversed().Bounds);
    }

    [Theory]
    [InlineData(1.0, 0.0, 1.0)]
    [InlineData(-1.0, 0.0, -1.0)]
    public void A_bulge_of_one_is_a_half_circle_and_its_sign_is_the_direction(double bulge, double centreY, double sign)
    {
        var arc = ArcSegment.FromBulge(new Point2D(0, 0), new Point2D(10, 0), bulge);

        Assert.Equal(new Point2D(5, centreY), arc.Centre);
        Assert.Equal(5.0, arc.Radius, precision: 12);
        Assert.Equal(180.0 * sign, arc.Sweep.Degrees, precision: 12);
        Assert.Equal(-5.0 * sign, arc.PointAt(0.5).Y, precision: 12);
    }

    [Fact]
    public void Distance_is_measured_to_the_arc_and_past_its_ends_to_the_nearer_end()
    {
        Assert.Equal(10.0, s_upperHalf.DistanceTo(new Point2D(100, 210)), precision: 12);
        Assert.Equal(50.0, s_upperHalf.DistanceTo(new Point2D(150, 100)), precision: 12);
    }

    [Fact]
    public void A_whole_turn_ends_exactly_where_it_starts()
    {
        var circle = new ArcSegment(new Point2D(0.1, 0.2), 0.3, Angle.FromDegrees(17), Angle.FullTurn);

        Assert.Equal(circle.StartPoint, circle.EndPoint);
        Assert.Equal(SegmentKind.Circle, Segment.FromArc(circle).Kind);
    }
}
