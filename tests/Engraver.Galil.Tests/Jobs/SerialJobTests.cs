using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Timing;
using Engraver.Galil.Tests.Programs.Timing;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>Jobs over a serial line with the transmission time of every byte.</summary>
public class SerialJobTests
{
    [Theory]
    [InlineData(JobMode.Stream, 115200)]
    [InlineData(JobMode.Stream, 19200)]
    [InlineData(JobMode.Stream, 9600)]
    [InlineData(JobMode.Stream, 1200)]
    [InlineData(JobMode.Calls, 19200)]
    [InlineData(JobMode.Calls, 1200)]
    public async Task The_papers_part_is_cut_whole_at_every_rate_and_the_watchdog_never_trips(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunSerialAsync(baud, MotionPrograms.Paper, mode);

        Assert.Equal((JobOutcome.Complete, 4, 0, 0), (result.Outcome, result.SegmentsExecuted, result.Underruns, result.Rejected));
        Assert.Empty(result.NotRestored);
        CutRecord.AssertWholePathWasCut(bench, MotionPrograms.Paper);
    }

    [Theory]
    [InlineData(19200, 900, 400)]
    [InlineData(9600, 600, 800)]
    [InlineData(115200, 1200, 100)]
    public async Task What_the_wire_carries_is_cut_at_full_feed_without_a_warning(int baud, int count, int step)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.ShortLines(count, step);
        var fit = LinkFeedFitting.Create(program, new SerialLine(baud), null);
        var sent = new List<string>();

        var result = await bench.RunSerialAsync(baud, fit.Program, JobMode.Stream, sending: sent.Add);

        Assert.Empty(fit.Diagnostics);
        Assert.Same(program, fit.Program);
        Assert.Equal((JobOutcome.Complete, count, 0), (result.Outcome, result.SegmentsExecuted, result.Underruns));
        Assert.DoesNotContain(sent, line => line.StartsWith("VR 0", StringComparison.Ordinal));
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    [Theory]
    [InlineData(19200, 60)]
    [InlineData(19200, 5)]
    [InlineData(1200, 100)]
    public async Task What_the_wire_does_not_carry_is_warned_of_and_cut_slower_without_an_underrun(int baud, int step)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.ShortLines(800, step);
        var fit = LinkFeedFitting.Create(program, new SerialLine(baud), null);
        var sent = new List<string>();

        var result = await bench.RunSerialAsync(baud, fit.Program, JobMode.Stream, sending: sent.Add);

        Assert.Equal(["MOT0020"], fit.Diagnostics.Select(finding => finding.Id));
        Assert.InRange(fit.Program.Strokes[0].Sequences[0].Speed, 2, program.Strokes[0].Sequences[0].Speed - 2);
        Assert.Equal((JobOutcome.Complete, 800, 0), (result.Outcome, result.SegmentsExecuted, result.Underruns));
        Assert.DoesNotContain(sent, line => line.StartsWith("VR 0", StringComparison.Ordinal));
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    [Theory]
    [InlineData(JobMode.Stream, "line")]
    [InlineData(JobMode.Calls, "line")]
    [InlineData(JobMode.Stream, "rapid")]
    [InlineData(JobMode.Stream, "arcs")]
    [InlineData(JobMode.Calls, "arcs")]
    public async Task Stop_goes_at_the_next_prompt_and_ends_at_rest_with_the_tool_off(JobMode mode, string place)
    {
        await using var bench = new SimulatedBench();
        var (program, far) = Job(place);
        using var stop = new CancellationTokenSource();
        var pressedAt = 0L;
        var press = new CancelWhen(progress => progress.X > far, () =>
        {
            pressedAt = bench.Controller.Status.Sample;
            stop.Cancel();
        });

        var result = await bench.RunSerialAsync(19200, program, mode, press, stop: stop.Token);

        Assert.Equal(JobOutcome.Stopped, result.Outcome);
        Assert.NotEqual(0, pressedAt);
        CutRecord.AssertSafeAfter(bench, pressedAt, toolSeconds: 0.15, restSeconds: 0.6);
        Assert.Equal(new CountsPoint(bench.Last.A, bench.Last.B), result.FinalPosition);
        Assert.Equal(0, bench.Controller.Status.RunningThreads);
    }

    [Theory]
    [InlineData(JobMode.Stream, "line")]
    [InlineData(JobMode.Calls, "arcs")]
    [InlineData(JobMode.Stream, "rapid")]
    public async Task A_cut_cable_trips_the_watchdog_in_the_controller(JobMode mode, string place)
    {
        await using var bench = new SimulatedBench();
        var (program, far) = Job(place);
        var cutAt = 0L;
        var cut = new CancelWhen(progress => progress.X > far, () =>
        {
            cutAt = bench.Controller.Status.Sample;
            bench.Controller.DropConnections();
        });

        var result = await bench.RunSerialAsync(19200, program, mode, cut);
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));

        Assert.Equal(JobOutcome.LinkLost, result.Outcome);
        CutRecord.AssertSafeAfter(bench, cutAt, toolSeconds: 1.5, restSeconds: 1.5);
    }

    [Property(MaxTest = 25)]
    public Property Whatever_the_segments_a_fitted_path_neither_runs_dry_nor_has_to_be_held_back() => Prop.ForAll(LinkFeedLimitTests.Sequences, async sequence =>
    {
        var program = new MotionProgram(MachineProfile.Default, default, [new MotionStroke(0, default, [sequence])]);
        var sent = new List<string>();
        var result = await CutAsync(LinkFeedFitting.Create(program, new SerialLine(19200), null).Program, sent);
        return (result.Outcome, result.SegmentsExecuted, result.Underruns) == (JobOutcome.Complete, program.SegmentCount, 0)
            && !sent.Any(line => line.StartsWith("VR 0", StringComparison.Ordinal));
    });

    private static async Task<JobResult> CutAsync(MotionProgram program, List<string> sent)
    {
        await using var bench = new SimulatedBench();
        return await bench.RunSerialAsync(19200, program, JobMode.Stream, sending: sent.Add);
    }

    private static (MotionProgram Program, int Far) Job(string place) => place switch
    {
        "line" => (MotionPrograms.LongLine(200000), 50000),
        "rapid" => (MotionPrograms.LongRapid(200000), 50000),
        "arcs" => (MotionPrograms.ArcChain(60, 1000), 31000),
        _ => throw new ArgumentOutOfRangeException(nameof(place)),
    };
}
