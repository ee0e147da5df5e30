using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>Another host switches the tool or halts the watchdog in the middle of a job, or a tool command is damaged on its way: it is detected and reported,
/// and the uncut part counts as missing.</summary>
public class ForeignAccessTests
{
    private const int Network = 0;

    public static TheoryData<JobMode, int> Everywhere => StalledJobTests.Everywhere;

    /// <summary>Over a network by the resulting state of the controller, on a serial line by the echo.</summary>
    private static JobOutcome Noticed(int baud) => baud == Network ? JobOutcome.Refused : JobOutcome.LinkLost;

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task A_tool_that_somebody_switched_off_stops_the_job_and_the_rest_is_missing(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var (at, sample) = (0, 0L);

        var result = await RunAsync(bench, MotionPrograms.LongLine(200000), mode, baud, progress => progress.X > 50000, () =>
        {
            (at, sample) = (bench.Last.A, bench.Controller.Status.Sample);
            bench.Interfere("CB 1");
        });
        var cut = result.LengthByStroke.Sum() + UnfinishedSegment.CutLength(MotionPrograms.LongLine(200000), result, 4.0);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("off while cutting", result.Message, StringComparison.Ordinal);
        Assert.Contains("drawing entity 0", result.Message, StringComparison.Ordinal);
        Assert.InRange(cut, at - 1000.0 - 3000.0, at - 1000.0); // at most one poll earlier
        CutRecord.AssertSafeAfter(bench, sample, toolSeconds: 0.1, restSeconds: 1.0);
    }

    [Theory]
    [InlineData(JobMode.Stream, Network)]
    [InlineData(JobMode.Calls, Network)]
    [InlineData(JobMode.Program, Network)]
    [InlineData(JobMode.Stream, 19200)]
    public async Task Segments_that_were_counted_while_the_tool_was_off_are_not_cut(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.ShortLines(1600);

        var result = await RunAsync(bench, program, mode, baud, progress => progress.X > 30000, () => bench.Interfere("CB 1"));
        var cut = result.LengthByStroke.Sum() + UnfinishedSegment.CutLength(program, result, 4.0);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.InRange(cut, 20000.0, Cut(bench));
        Assert.InRange(result.SegmentsExecuted, 400, 1500);
    }

    /// <summary>Command, operand that shows it, and how long the tool may be on afterwards, s: a speed that is too high is detected in two polls, one that is
    /// too low after half a second.</summary>
    public static TheoryData<string, string, double, JobMode, int> Feeds()
    {
        var feeds = new TheoryData<string, string, double, JobMode, int>();
        foreach (var (mode, baud) in Everywhere.Select(row => ((JobMode)row[0]!, (int)row[1]!)))
        {
            var link = baud == Network ? 0.0 : 0.7;
            feeds.Add("VSS=200000", "_VSS 200000", 0.2 + link, mode, baud);
            feeds.Add("VR 1.875", "_VRS 1.875", 0.2 + link, mode, baud);
            feeds.Add("VR 0.0625", "_VRS 0.0625", 0.8 + link, mode, baud);
            feeds.Add("VR 0", "_VRS 0", 0.8 + link, mode, baud);
        }

        return feeds;
    }

    [Theory]
    [MemberData(nameof(Feeds))]
    public async Task A_feed_that_somebody_changed_stops_the_job_and_stays_as_it_was_changed(string command, string held, double toolSeconds, JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var sample = 0L;

        var result = await RunAsync(bench, MotionPrograms.LongLine(400000), mode, baud, progress => progress.X > 50000, () =>
        {
            sample = bench.Controller.Status.Sample;
            bench.Interfere(command);
        });

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("changed the feed", result.Message, StringComparison.Ordinal);
        Assert.Contains(held, result.Message, StringComparison.Ordinal);
        Assert.Contains("drawing entity 0", result.Message, StringComparison.Ordinal);
        CutRecord.AssertSafeAfter(bench, sample, toolSeconds, restSeconds: toolSeconds + 2.0);
        var (operand, value) = (held.Split(' ')[0], held.Split(' ')[1]);
        Assert.Equal(value, await bench.NumberAsync(operand));
    }

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task Slow_ramps_and_short_motions_of_the_job_are_its_own(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var profile = MachineProfile.Default with { AccelerationCounts = 10240 };
        var lines = MotionPrograms.ShortLines(40);

        foreach (var program in new[] { MotionPrograms.LongLine(60000) with { Profile = profile }, lines with { Profile = profile } })
        {
            var result = await RunAsync(bench, program, mode, baud, _ => false, () => { });

            Assert.Equal((JobOutcome.Complete, program.SegmentCount), (result.Outcome, result.SegmentsExecuted));
        }
    }

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task A_watchdog_that_somebody_halted_stops_the_job(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var sample = 0L;

        var result = await RunAsync(bench, MotionPrograms.LongLine(200000), mode, baud, progress => progress.X > 50000, () =>
        {
            sample = bench.Controller.Status.Sample;
            bench.Interfere("HX1");
        });

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("watchdog", result.Message, StringComparison.Ordinal);
        CutRecord.AssertSafeAfter(bench, sample, toolSeconds: 1.0, restSeconds: 1.5);
    }

    [Theory]
    [InlineData("SB 1", "SB 2", JobMode.Stream, Network)]
    [InlineData("SB 1", "CB 1", JobMode.Stream, Network)]
    [InlineData("SB 1", "SB 2", JobMode.Calls, Network)]
    [InlineData("SB 1", "SB 2", JobMode.Stream, 19200)]
    [InlineData("SB 1", "SB 2", JobMode.Calls, 19200)]
    public async Task A_tool_command_that_arrived_as_another_one_cuts_nothing(string sent, string arrived, JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();

        var result = await RunAsync(bench, MotionPrograms.Paper, mode, baud, _ => false, () => { }, line => line.Replace(sent, arrived, StringComparison.Ordinal));

        Assert.Equal((Noticed(baud), 0), (result.Outcome, result.SegmentsExecuted));
        Assert.Contains(baud == Network ? "off while cutting" : "instead of 'SB 1'", result.Message, StringComparison.Ordinal);
        Assert.Equal(new CountsPoint(5000, 5000), result.FinalPosition);
    }

    [Theory]
    [InlineData(JobMode.Stream, Network)]
    [InlineData(JobMode.Calls, Network)]
    [InlineData(JobMode.Stream, 19200)]
    [InlineData(JobMode.Calls, 19200)]
    public async Task A_tool_that_did_not_go_off_is_not_taken_along_to_the_next_stroke(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var (isOn, isHarmed) = (false, false);
        string Harm(string line)
        {
            isOn |= line == "SB 1\r";
            if (!isOn || isHarmed || line != "CB 1\r") return line;
            isHarmed = true;
            return "CB 2\r";
        }

        var result = await RunAsync(bench, MotionPrograms.TwoStrokes, mode, baud, _ => false, () => { }, Harm);

        Assert.Equal((Noticed(baud), 0), (result.Outcome, bench.Controller.Status.Outputs & 1));
        Assert.Contains(baud == Network ? "on where it must be off" : "instead of 'CB 1'", result.Message, StringComparison.Ordinal);
        CutRecord.AssertNothingElseWasCut(bench, MotionPrograms.TwoStrokes);
    }

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task A_tool_that_somebody_switched_on_in_a_rapid_goes_off_again(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var sample = 0L;

        var result = await RunAsync(bench, MotionPrograms.LongRapid(200000), mode, baud, progress => progress.X > 50000, () =>
        {
            sample = bench.Controller.Status.Sample;
            bench.Interfere("SB 1");
        });

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("on where it must be off", result.Message, StringComparison.Ordinal);
        CutRecord.AssertSafeAfter(bench, sample, toolSeconds: 1.0, restSeconds: 2.0);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_dry_run_with_the_tool_on_ends(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        var act = new CancelWhen(progress => progress.X > 50000, () => bench.Interfere("SB 1"));

        var result = await JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, SimulatedBench.Job with { Strategy = mode.Strategy(), DryRun = true }, act, CancellationToken.None);

        Assert.Equal((JobOutcome.Refused, 0), (result.Outcome, bench.Controller.Status.Outputs));
    }

    private static async Task<JobResult> RunAsync(
        SimulatedBench bench, MotionProgram program, JobMode mode, int baud, Func<JobProgress, bool> when, Action act, Func<string, string>? harm = null)
    {
        await using var session = baud == Network ? await bench.OpenAsync(opened: link => link.Corrupt = harm) : await bench.OpenSerialAsync(baud, harm: harm);
        return await JobRunner.RunAsync(program, session, SimulatedBench.Job with { Strategy = mode.Strategy() }, new CancelWhen(when, act), CancellationToken.None);
    }

    /// <summary>The path of the motors with the tool on, by the record, counts.</summary>
    private static double Cut(SimulatedBench bench)
    {
        var rows = bench.Controller.Record.Snapshot();
        return rows.Zip(rows.Skip(1)).Where(pair => (pair.First.Outputs & 1) != 0).Sum(pair => Math.Sqrt(Math.Pow(pair.Second.A - pair.First.A, 2) + Math.Pow(pair.Second.B - pair.First.B, 2)));
    }
}
