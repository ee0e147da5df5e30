using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Core.Tests.Motion;

/// <summary>By how much a sequence can be cut faster than planned, compared with an independent calculation.</summary>
public class SpeedHeadroomTests
{
    private const double Acceleration = 256000.0;

    [Theory]
    [InlineData(20000, 1.7)] // sqrt(256000 x 5000) / 20000 = 1.79
    [InlineData(10000, 2.0)]
    [InlineData(40000, 1.0)] // at its limit already
    public void An_arc_bears_the_root_of_acceleration_times_radius(int speed, double most)
    {
        var arc = new VectorSegment(VectorSegmentKind.Arc, new(10000, 0), 5000, 180, -180, 0, 5000 * Math.PI);

        Assert.Equal(most, Of(new VectorSequence(default, speed, [arc])), 6);
    }

    [Theory]
    [InlineData(8.0, 1.0)] // 256 / (2 sin 4) = 1835
    [InlineData(6.0, 1.2)] // 256 / (2 sin 3) = 2446
    [InlineData(4.0, 1.8)] // 256 / (2 sin 2) = 3668
    [InlineData(3.0, 2.0)]
    public void At_a_joint_the_velocity_changes_in_one_sample(double turnDegrees, double most)
    {
        var end = CountsScale.Round(new(100_000 + (100_000 * Math.Cos(turnDegrees * Math.PI / 180.0)), 100_000 * Math.Sin(turnDegrees * Math.PI / 180.0)));

        Assert.Equal(most, Of(new VectorSequence(default, 2000, [Line(default, new(100_000, 0)), Line(new(100_000, 0), end)])), 6);
    }

    [Fact]
    public void A_bend_in_height_counts_as_one_in_plan()
    {
        var rise = (int)Math.Round(100_000 * Math.Tan(6.0 * Math.PI / 180.0));

        Assert.Equal(1.2, Of(new VectorSequence(default, 2000, [Line(default, new(100_000, 0)), Line(new(100_000, 0), new(200_000, 0, rise))]) { ChangesHeight = true }), 6);
    }

    /// <summary>Its brakes fit the planned speeds only.</summary>
    [Fact]
    public void A_sequence_that_brakes_on_its_way_is_not_run_faster() =>
        Assert.Equal(1.0, Of(new VectorSequence(default, 2000, [Line(default, new(100_000, 0)) with { Speed = 2000 }, Line(new(100_000, 0), new(200_000, 0)) with { Speed = 1000 }])));

    [Fact]
    public void The_controllers_fastest_speed_and_what_is_asked_for_are_limits_too()
    {
        var straight = new VectorSequence(default, 20000, [Line(default, new(100_000, 0))]);

        Assert.Equal((2.0, 1.5, 1.0), (Of(straight), SpeedHeadroom.Of([straight], MachineProfile.Default, 30000, 2.0), SpeedHeadroom.Of([straight], MachineProfile.Default, 5000, 2.0)));
    }

    private static double Of(VectorSequence sequence) => SpeedHeadroom.Of([sequence], MachineProfile.Default with { AccelerationCounts = (int)Acceleration }, 12_000_000, 2.0);

    private static VectorSegment Line(CountsPoint from, CountsPoint to) => new(VectorSegmentKind.Line, to, 0, 0, 0, 0, double.Hypot(double.Hypot(to.X - from.X, to.Y - from.Y), to.Z - from.Z));
}
