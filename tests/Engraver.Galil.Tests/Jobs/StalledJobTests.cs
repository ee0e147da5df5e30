using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>No motion and no progress although there should be: the job ends with the tool off and reports position and reason. A job that is only slow
/// continues.</summary>
public class StalledJobTests
{
    private const int Network = 0;

    public static TheoryData<JobMode, int> Everywhere => new()
    {
        { JobMode.Stream, Network },
        { JobMode.Calls, Network },
        { JobMode.Program, Network },
        { JobMode.Stream, 19200 },
        { JobMode.Calls, 19200 },
        { JobMode.Program, 19200 },
    };

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task A_feed_override_of_nothing_from_another_handle_ends_the_job(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var stoppedAt = 0L;

        var result = await RunAsync(bench, MotionPrograms.LongLine(200000), mode, baud, progress => progress.X > 50000, () =>
        {
            stoppedAt = bench.Controller.Status.Sample;
            bench.Interfere("VR 0");
        });

        Assert.Equal((JobOutcome.Refused, 0), (result.Outcome, result.SegmentsExecuted));
        Assert.Contains("_VRS 0", result.Message, StringComparison.Ordinal);
        Assert.Contains("stroke 1, drawing entity 0", result.Message, StringComparison.Ordinal);
        CutRecord.AssertSafeAfter(bench, stoppedAt, toolSeconds: baud == Network ? 0.8 : 1.5, restSeconds: 1.5);
    }

    [Theory]
    [InlineData("go=1", "o=1", 1, JobMode.Calls, Network)] // the first is the empty call at the start, with the tool off
    [InlineData("go=1", "o=1", 0, JobMode.Calls, Network)]
    [InlineData("go=1", "o=1", 1, JobMode.Calls, 19200)] // detected by the echo
    [InlineData("SPA=", "SPA=0;g=", 0, JobMode.Stream, Network)] // detected when it is read back
    [InlineData("SPA=", "SPA=0;g=", 0, JobMode.Calls, 19200)]
    public async Task A_command_that_arrived_as_another_one_does_not_keep_the_job_waiting_for_ever(string sent, string arrived, int nth, JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var seen = 0;
        string Harm(string line)
        {
            if (!line.StartsWith(sent, StringComparison.Ordinal) || line.IndexOf('\r') != line.Length - 1 || seen++ != nth) return line; // not part of a download
            return arrived.Contains(';', StringComparison.Ordinal) ? arrived[..arrived.IndexOf(';', StringComparison.Ordinal)] + "\r" : arrived + line[sent.Length..];
        }

        var result = await RunAsync(bench, MotionPrograms.Paper, mode, baud, _ => false, () => { }, Harm);

        var isSeenAtOnce = baud != Network || sent == "SPA=";
        Assert.Equal(isSeenAtOnce ? JobOutcome.LinkLost : JobOutcome.Refused, result.Outcome);
        Assert.Contains(baud != Network ? "the line corrupts data" : isSeenAtOnce ? "was sent" : "No motion and no progress", result.Message, StringComparison.Ordinal);
        if (!isSeenAtOnce) Assert.Contains("drawing entity 0", result.Message, StringComparison.Ordinal);
        Assert.Equal((0, 0, false), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads, bench.Controller.Status.IsMoving));
    }

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task A_cut_that_is_only_slow_comes_to_its_end(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();

        var program = MotionPrograms.LongLine(6000);
        var sequence = program.Strokes[0].Sequences[0];
        program = program with { Strokes = [program.Strokes[0] with { Sequences = [sequence with { Speed = 100 }] }] };

        var result = await RunAsync(bench, program, mode, baud, _ => false, () => { }, patience: 200.0);

        Assert.Equal((JobOutcome.Complete, 1), (result.Outcome, result.SegmentsExecuted));
        Assert.InRange(result.Seconds, 15.0, 200.0);
    }

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task A_tool_that_settles_for_longer_than_a_job_may_stand_is_waited_for(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongLine(1000) with { Profile = MachineProfile.Default with { ToolSettleSeconds = 12.0 } };

        var result = await RunAsync(bench, program, mode, baud, _ => false, () => { });

        Assert.Equal((JobOutcome.Complete, 1), (result.Outcome, result.SegmentsExecuted));
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    [Fact]
    public async Task A_slow_line_that_fills_the_buffer_while_the_tool_is_on_is_no_standstill()
    {
        await using var bench = new SimulatedBench();
        var first = MotionPrograms.ShortLines(2).Strokes[0].Sequences[0];
        var second = new VectorSequence(first.End, 20000, [.. Enumerable.Range(1, 480).Select(i => MotionPrograms.Line(120 + (i * 60), i % 2, i + 1, Math.Sqrt(3601.0)))]);
        var program = MotionPrograms.LongLine(1) with { Strokes = [new MotionStroke(0, first.Start, [first, second])] };

        var result = await RunAsync(bench, program, JobMode.Stream, 4800, _ => false, () => { });

        Assert.Equal((JobOutcome.Complete, 482), (result.Outcome, result.SegmentsExecuted));
        Assert.InRange(result.Seconds, 15.0, 60.0); // the bytes of the second sequence take far longer than the standstill limit
    }

    /// <summary>Runs a job in which <paramref name="act"/> is called once; the operator stops it after <paramref name="patience"/> seconds of the controller,
    /// so that the test of an endless job ends.</summary>
    private static async Task<JobResult> RunAsync(
        SimulatedBench bench, MotionProgram program, JobMode mode, int baud, Func<JobProgress, bool> when, Action act, Func<string, string>? harm = null, double patience = 60.0)
    {
        using var stop = new CancellationTokenSource();
        var acting = new CancelWhen(when, act);
        var progress = new ProgressPair(acting, new CancelWhen(now => now.Seconds > patience, stop.Cancel));
        await using var session = baud == Network ? await bench.OpenAsync(opened: link => link.Corrupt = harm) : await bench.OpenSerialAsync(baud, harm: harm);
        return await JobRunner.RunAsync(program, session, SimulatedBench.Job with { Strategy = mode.Strategy() }, progress, stop.Token);
    }
}
