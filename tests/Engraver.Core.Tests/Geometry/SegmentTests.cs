using Engraver.Core.Geometry;

namespace Engraver.Core.Tests.Geometry;

public class SegmentTests
{
    [Fact]
    public void A_line_has_no_arc() => Assert.Throws<InvalidOperationException>(() => Segment.FromLine(default, new Point2D(1, 0)).Arc);

    [Fact]
    public void Reversing_swaps_ends_and_turns_tangents_round()
    {
        var segment = Segment.FromArc(new ArcSegment(new Point2D(3, 4), 5, Angle.FromDegrees(30), Angle.FromDegrees(100)));
        var back = segment.Reversed();

        Assert.Equal(segment.Start, back.End);
        Assert.Equal(segment.End, back.Start);
        Assert.Equal(0.0, (segment.StartTangent + back.EndTangent).Length, precision: 12);
        Assert.Equal(segment.Length, back.Length);
    }

    [Fact]
    public void The_tangent_of_a_line_without_length_is_zero() => Assert.Equal(default, Segment.FromLine(new Point2D(1, 1), new Point2D(1, 1)).StartTangent);

    [Fact]
    public void The_turn_between_two_directions_is_left_positive() =>
        Assert.Equal(90.0, new Vector2D(1, 0).TurnTo(new Vector2D(0, 2)).Degrees, precision: 12);
}
