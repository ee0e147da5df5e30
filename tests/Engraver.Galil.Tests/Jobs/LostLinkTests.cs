using Engraver.Galil.Jobs;

namespace Engraver.Galil.Tests.Jobs;

public class LostLinkTests
{
    [Theory]
    [InlineData(JobMode.Stream, "line")]
    [InlineData(JobMode.Calls, "line")]
    [InlineData(JobMode.Stream, "rapid")]
    [InlineData(JobMode.Stream, "arcs")]
    [InlineData(JobMode.Calls, "arcs")]
    [InlineData(JobMode.Stream, "short")]
    public async Task A_cut_link_ends_within_a_second_and_a_half_with_the_tool_off_at_rest(JobMode mode, string place)
    {
        await using var bench = new SimulatedBench();
        var (program, far) = place switch
        {
            "line" => (MotionPrograms.LongLine(200000), 50000),
            "rapid" => (MotionPrograms.LongRapid(200000), 50000),
            "short" => (MotionPrograms.ShortLines(1600), 40000),
            _ => (MotionPrograms.ArcChain(60, 1000), 31000),
        };
        var cutAt = 0L;
        var cut = new CancelWhen(progress => progress.X > far, () =>
        {
            cutAt = bench.Controller.Status.Sample;
            bench.Controller.DropConnections();
        });

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Mode = mode }, cut);
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));

        Assert.Equal(JobOutcome.LinkLost, result.Outcome);
        Assert.NotNull(result.FinalPosition);
        Assert.InRange(result.FinalPosition.Value.X, far, far + 5000);
        CutRecord.AssertSafeAfter(bench, cutAt, toolSeconds: 1.5, restSeconds: 1.5);
    }

    [Fact]
    public async Task A_controller_that_freezes_is_given_up_after_the_time_out()
    {
        await using var bench = new SimulatedBench(new() { FreezeAfterCommands = 200 });
        var time = new Engraver.TestKit.ManualTimeProvider();
        await using var session = await bench.OpenAsync(time);

        var running = JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, SimulatedBench.Job, null, CancellationToken.None);
        while (!running.IsCompleted)
        {
            time.Advance(TimeSpan.FromSeconds(1));
            await Task.Yield();
        }

        var result = await running;
        Assert.Equal(JobOutcome.LinkLost, result.Outcome);
        Assert.Contains("did not answer", result.Sentence, StringComparison.Ordinal);
    }
}
