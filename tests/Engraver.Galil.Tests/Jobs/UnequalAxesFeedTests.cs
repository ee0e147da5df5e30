using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Tests.Programs;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>If a millimetre of X and one of Y are different numbers of counts, the controller's vector speed is not a speed in millimetres: the motion of the
/// motors is compared with the requested feed.</summary>
public class UnequalAxesFeedTests
{
    private const double FeedMmPerSecond = 10.0;

    /// <summary>With this number of samples of 1 ms, rounding to counts is a ten-thousandth of the path.</summary>
    private const int Window = 100;

    [Theory]
    [InlineData(400.0, 1000.0, JobMode.Stream)]
    [InlineData(1000.0, 250.0, JobMode.Stream)]
    [InlineData(-2000.0, 125.0, JobMode.Stream)]
    [InlineData(400.0, 1000.0, JobMode.Calls)]
    [InlineData(1000.0, -250.0, JobMode.Program)]
    public async Task In_no_direction_the_tool_is_faster_than_the_feed_and_along_the_coarse_axis_it_is_as_fast(double countsX, double countsY, JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var profile = MachineProfile.Default with { Axes = MachineAxes.FromScale(countsX, countsY), FeedMmPerMinute = 60.0 * FeedMmPerSecond };
        var program = MotionProgramGenerator.Generate(Star(), profile, new(0.001, 0.0), null, mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous).Program!;

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy() });

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        var speeds = Speeds(bench.Controller.Record.Snapshot(), profile).ToList();
        var isCoarseX = Math.Abs(countsX) < Math.Abs(countsY);
        Assert.InRange(speeds.Max(speed => speed.Along), 0.0, FeedMmPerSecond * 1.0005);
        Assert.InRange(speeds.Max(speed => isCoarseX ? speed.X : speed.Y), FeedMmPerSecond * 0.9995, FeedMmPerSecond * 1.0005);
    }

    /// <summary>Lines from the middle in 24 directions, and a circle.</summary>
    private static Toolpath Star()
    {
        var lines = Enumerable.Range(0, 24).Select(i => new[] { Segment.FromLine(default, new Point2D(12 * Math.Cos(i * Math.PI / 12), 12 * Math.Sin(i * Math.PI / 12))) });
        return Toolpaths.OfStrokes([.. lines, [Toolpaths.Arc(0, 0, 6, 0, 360)]]);
    }

    /// <summary>Over every window in which the tool is always on, mm/s; the speed along the path is at least that of the chord.</summary>
    private static IEnumerable<(double Along, double X, double Y)> Speeds(IReadOnlyList<MotionSample> record, MachineProfile profile)
    {
        for (var i = Window; i < record.Count; i++)
        {
            var (from, to) = (record[i - Window], record[i]);
            if ((from.Outputs & to.Outputs & 1) == 0) continue;
            var seconds = to.Seconds - from.Seconds;
            var (x, y) = (profile.Scale.X.LengthOf(Math.Abs(to.A - from.A)) / seconds, profile.Scale.Y.LengthOf(Math.Abs(to.B - from.B)) / seconds);
            yield return (Math.Sqrt((x * x) + (y * y)), x, y);
        }
    }
}
