using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Timing;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Timing;
using Engraver.Galil.Tests.Programs;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Jobs.Timing;

/// <summary>The planned duration of a job on a link, compared with the same job on the simulated controller.</summary>
public class JobTimeTests
{
    private static readonly int[] s_rates = [1200, 9600, 19200, 38400, 115200];

    public static TheoryData<JobMode, int, string> Jobs
    {
        get
        {
            var jobs = new TheoryData<JobMode, int, string>();
            foreach (var mode in Enum.GetValues<JobMode>())
            {
                foreach (var baud in s_rates)
                {
                    foreach (var part in (string[])["many", "far", "short"]) jobs.Add(mode, baud, part);
                }
            }

            return jobs;
        }
    }

    [Theory]
    [MemberData(nameof(Jobs))]
    public async Task Over_a_serial_line_a_part_takes_as_long_as_was_planned(JobMode mode, int baud, string part)
    {
        var (planned, took) = await PlannedAndRunAsync(mode, baud, part);

        Assert.InRange(planned, 0.98 * took, 1.02 * took);
    }

    /// <summary>Lines of several segments, with heartbeats in front of some of them.</summary>
    [Theory]
    [InlineData(9600)]
    [InlineData(19200)]
    [InlineData(115200)]
    public async Task A_path_of_many_segments_takes_as_long_as_was_planned(int baud)
    {
        var (planned, took) = await PlannedAndRunAsync(JobMode.Stream, baud, "dense");

        Assert.InRange(planned, 0.98 * took, 1.02 * took);
    }

    /// <summary>All cuts are as long as three polls: a heartbeat in between decides whether there is a fourth poll, and this can happen in each of
    /// them.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    public async Task Cuts_that_beat_with_the_polls_of_the_job_may_take_one_poll_more_or_less(JobMode mode)
    {
        foreach (var baud in s_rates)
        {
            var (planned, took) = await PlannedAndRunAsync(mode, baud, "squares");

            Assert.InRange(planned, 0.95 * took, 1.05 * took);
        }
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public void The_wire_lengthens_the_standing_and_nothing_else(JobMode mode)
    {
        var program = ManyStrokes(mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous);
        var network = JobTime.Estimate(program, null, mode);
        var fast = JobTime.Estimate(program, new SerialLine(115200), mode);
        var slow = JobTime.Estimate(program, new SerialLine(1200), mode);

        Assert.Equal((network.Cutting, network.Rapid), (slow.Cutting, slow.Rapid));
        Assert.True(network.Dwell < fast.Dwell && 5.0 * fast.Dwell < slow.Dwell);
    }

    [Fact]
    public void Without_a_wire_the_plan_is_that_of_the_network_and_nothing_to_cut_takes_no_time()
    {
        var program = ManyStrokes(MotionStyle.Continuous);

        Assert.Equal(MotionTime.Calculate(program, DmcTimes.Ethernet), JobTime.Estimate(program, null, JobMode.Stream));
        foreach (var mode in Enum.GetValues<JobMode>()) Assert.Equal(0.0, JobTime.Estimate(program with { Strokes = [] }, new SerialLine(1200), mode).Total);
    }

    private static async Task<(double Planned, double Took)> PlannedAndRunAsync(JobMode mode, int baud, string part)
    {
        await using var bench = new SimulatedBench(clock: new ManualTimeProvider()); // only bytes advance the time, however busy this computer is
        var made = Part(part, mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous);
        var program = mode == JobMode.Stream ? LinkFeedFitting.Create(made, new SerialLine(baud), null).Program : made;
        var planned = JobTime.Estimate(program, new SerialLine(baud), mode).Total;
        var result = await bench.RunSerialAsync(baud, program, mode);

        Assert.True(result.Outcome == JobOutcome.Complete, result.Message);
        return (planned, result.Seconds);
    }

    private static MotionProgram ManyStrokes(MotionStyle style) => Part("many", style);

    private static MotionProgram Part(string name, MotionStyle style) => MotionProgramGenerator.Generate(
        name switch
        {
            // lines, corners and arcs of one to forty millimetres, with rapids of all lengths between
            "many" => Toolpaths.OfStrokes(
                [Toolpaths.Line(1, 1, 3, 1)], [Toolpaths.Arc(30, 5, 4, 0, 360)], [Toolpaths.Line(30, 9, 70, 9), Toolpaths.Line(70, 9, 70, 20)],
                [Toolpaths.Line(70, 21, 69, 21)], [Toolpaths.Arc(20, 30, 2, 90, 180)], [Toolpaths.Line(-5, 30, -5, -12)]),
            "far" => Toolpaths.OfStrokes([.. Enumerable.Range(0, 10).Select(i => new[] { Toolpaths.Line(100, 100 + (20 * i), 150, 100 + (20 * i)) })]),
            "short" => Toolpaths.OfStrokes([.. Enumerable.Range(0, 30).Select(i => new[] { Toolpaths.Line(10, 10 + i, 11, 10 + i) })]),
            "dense" => Toolpaths.OfStrokes([.. Enumerable.Range(0, 700).Select(i => Toolpaths.Line(0.3 * i, 0.01 * (i % 2), 0.3 * (i + 1), 0.01 * ((i + 1) % 2)))]),
            "squares" => Toolpaths.OfStrokes([.. Enumerable.Range(0, 12).Select(i => Square(5 * i, 3))]),
            _ => throw new ArgumentOutOfRangeException(nameof(name)),
        },
        MachineProfile.Default, new(0.001, 0.0), null, style).Program!;

    private static Segment[] Square(double x, double side) =>
        [Toolpaths.Line(x, 0, x + side, 0), Toolpaths.Line(x + side, 0, x + side, side), Toolpaths.Line(x + side, side, x, side), Toolpaths.Line(x, side, x, 0)];
}
