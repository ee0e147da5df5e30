using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Programs.Timing;

public class MotionPeaksTests
{
    [Fact]
    public void A_long_line_along_x_reaches_the_feed_and_the_acceleration_of_the_profile()
    {
        var peaks = MotionPeaks.From(Cutting(new CountsPoint(0, 0), Line(100_000, 0, 100_000.0)));

        Assert.Equal(20.0, peaks.Speed, precision: 9);
        Assert.Equal(256.0, peaks.AxisAcceleration, precision: 9);
    }

    [Fact]
    public void A_short_line_does_not_reach_the_feed() => Assert.Equal(
        Math.Sqrt(256.0 * 0.5), MotionPeaks.From(Cutting(new CountsPoint(0, 0), Line(500, 0, 500.0))).Speed, precision: 9);

    [Fact]
    public void A_slanted_line_asks_less_of_each_axis() => Assert.Equal(
        256.0 * 0.8, MotionPeaks.From(Cutting(new CountsPoint(0, 0), Line(60_000, 80_000, 100_000.0))).AxisAcceleration, precision: 9);

    [Fact]
    public void In_a_small_circle_the_axis_feels_speed_squared_over_radius()
    {
        var circle = new VectorSegment(VectorSegmentKind.Arc, new CountsPoint(1000, 0), 1000, 0.0, 360.0, 0, 2000.0 * Math.PI);
        var peaks = MotionPeaks.From(Cutting(new CountsPoint(1000, 0), circle));

        Assert.InRange(peaks.AxisAcceleration, 20.0 * 20.0 / 1.0, (20.0 * 20.0 / 1.0) + 256.0);
    }

    [Fact]
    public void A_turn_that_is_run_through_is_taken_in_one_sample()
    {
        var turn = Cutting(new CountsPoint(0, 0), Line(100_000, 0, 100_000.0), Line(200_000, 10_000, Math.Sqrt(1.01e10)));

        Assert.Equal(20.0 * (10_000.0 / Math.Sqrt(1.01e10)) / 0.001, MotionPeaks.From(turn).AxisAcceleration, precision: 6);
    }

    [Fact]
    public void Nothing_to_cut_asks_nothing() => Assert.Equal(default, MotionPeaks.From(new MotionProgram(MachineProfile.Default, default, [])));

    private static VectorSegment Line(int x, int y, double length) => new(VectorSegmentKind.Line, new CountsPoint(x, y), 0, 0.0, 0.0, 0, length);

    private static MotionProgram Cutting(CountsPoint start, params VectorSegment[] segments) =>
        new(MachineProfile.Default, start, [new MotionStroke(0, start, [new VectorSequence(start, MachineProfile.Default.VectorSpeed(), segments)])]);
}
