using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;

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
    [InlineData(JobMode.Program, "line")]
    [InlineData(JobMode.Program, "rapid")]
    [InlineData(JobMode.Program, "arcs")]
    [InlineData(JobMode.Program, "short")]
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

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy() }, cut);
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));

        Assert.Equal(JobOutcome.LinkLost, result.Outcome);
        Assert.NotNull(result.FinalPosition);
        if (result.FinalPosition.Value.X != bench.Last.A) Assert.Contains("more segments may be cut than are counted here", result.Message, StringComparison.Ordinal);
        Assert.InRange(result.FinalPosition.Value.X, far, bench.Last.A); // queried between the cut and the standstill: a handle may be available again
        CutRecord.AssertSafeAfter(bench, cutAt, toolSeconds: 1.5, restSeconds: 1.5);
    }

    [Fact]
    public async Task A_controller_that_freezes_is_given_up_after_the_time_out()
    {
        await using var bench = new SimulatedBench(new() { FreezeAfterCommands = 200 });

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job);

        Assert.Equal(JobOutcome.LinkLost, result.Outcome);
        Assert.Contains("did not reply", result.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task When_only_the_command_handle_is_cut_the_other_one_stops_the_machine_and_leaves_it_as_found()
    {
        await using var bench = new SimulatedBench(new() { Drops = [new(Handle: 0, AfterCommands: 400)] });
        await using (var session = await bench.OpenAsync())
        {
            var result = await JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, SimulatedBench.Job, null, CancellationToken.None);

            Assert.Equal(JobOutcome.LinkLost, result.Outcome);
            Assert.Empty(result.NotRestored);
            Assert.Equal(new CountsPoint(bench.Last.A, bench.Last.B), result.FinalPosition);
        }

        Assert.Equal((false, 0, 0), (bench.Controller.Status.IsMoving, bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads));
        await using var fresh = new SimulatedBench();
        Assert.Equal(await fresh.FingerprintAsync(), await bench.FingerprintAsync());
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_host_that_was_held_up_finds_that_the_watchdog_has_stopped_the_machine(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var heldAt = 0L;
        var held = new CancelWhen(progress => progress.X > 50000, () =>
        {
            heldAt = bench.Controller.Status.Sample;
            bench.Controller.Advance(TimeSpan.FromSeconds(2));
        });

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Strategy = mode.Strategy() }, held);

        Assert.Equal((JobOutcome.LinkLost, 0), (result.Outcome, result.SegmentsExecuted));
        Assert.Contains("watchdog", result.Message, StringComparison.Ordinal);
        CutRecord.AssertSafeAfter(bench, heldAt, toolSeconds: 1.5, restSeconds: 1.5);
    }

    [Fact]
    public async Task The_program_that_a_dead_run_had_found_is_given_back_by_the_next_one_with_its_journal()
    {
        await using var bench = new SimulatedBench();
        await bench.DownloadAsync("#OWNER\nEN");
        var folder = Directory.CreateTempSubdirectory();
        var options = SimulatedBench.Job with { JournalPath = Path.Combine(folder.FullName, "job.jsonl") };
        await bench.RunAsync(MotionPrograms.LongLine(200000), options, new CancelWhen(progress => progress.X > 50000, bench.Controller.DropConnections));
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));

        var result = await bench.RunAsync(MotionPrograms.Paper, options with { Strategy = JobMode.Calls.Strategy() });

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.EndsWith(new Accepted("#OWNER\nEN").ToString(), await bench.FingerprintAsync(), StringComparison.Ordinal);
        folder.Delete(recursive: true);
    }
}
