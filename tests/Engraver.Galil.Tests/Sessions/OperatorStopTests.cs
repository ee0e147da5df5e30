using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using Engraver.Galil.Tests.Jobs;
using Engraver.Galil.Tests.Links;

namespace Engraver.Galil.Tests.Sessions;

public class OperatorStopTests
{
    public static TheoryData<JobMode, string> Places => new()
    {
        { JobMode.Stream, "line" },
        { JobMode.Calls, "line" },
        { JobMode.Stream, "rapid" },
        { JobMode.Calls, "rapid" },
        { JobMode.Stream, "arcs" },
        { JobMode.Calls, "arcs" },
        { JobMode.Stream, "short" },
        { JobMode.Program, "line" },
        { JobMode.Program, "rapid" },
        { JobMode.Program, "arcs" },
        { JobMode.Program, "short" },
    };

    [Theory]
    [MemberData(nameof(Places))]
    public async Task Stop_switches_the_tool_off_at_once_and_ends_at_rest(JobMode mode, string place)
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

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy() }, press, stop.Token);

        Assert.Equal((JobOutcome.Stopped, "Stopped by the operator."), (result.Outcome, result.Message));
        Assert.NotEqual(0, pressedAt);
        CutRecord.AssertSafeAfter(bench, pressedAt, toolSeconds: 0.01, restSeconds: 0.5);
        CutRecord.AssertNothingElseWasCut(bench, program);
        Assert.Equal(new CountsPoint(bench.Last.A, bench.Last.B), result.FinalPosition);
        Assert.InRange(result.SegmentsExecuted, 0, program.SegmentCount - 1);
        Assert.Equal(0, bench.Controller.Status.RunningThreads);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Program)]
    public async Task The_segments_done_before_the_stop_are_counted_by_the_controller(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();

        var result = await bench.RunAsync(MotionPrograms.ShortLines(1600), SimulatedBench.Job with { Strategy = mode.Strategy() }, new CancelWhen(progress => progress.X > 30000, stop.Cancel), stop.Token);

        Assert.InRange(result.SegmentsExecuted, (bench.Last.A / 60) - 1, (bench.Last.A / 60) + 1);
        Assert.Equal(result.SegmentsExecuted, result.ExecutedEntityIndices.Count);
    }

    [Fact]
    public async Task After_a_stop_the_next_job_runs()
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();
        await bench.RunAsync(MotionPrograms.LongLine(100000), SimulatedBench.Job, new CancelWhen(progress => progress.X > 20000, stop.Cancel), stop.Token);

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job);

        Assert.Equal((JobOutcome.Complete, 4), (result.Outcome, result.SegmentsExecuted));
    }

    [Fact]
    public async Task A_stop_before_the_start_moves_nothing()
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job, null, new CancellationToken(true));

        Assert.Equal((JobOutcome.Stopped, 0), (result.Outcome, result.SegmentsSent));
        Assert.All(bench.Controller.Record.Snapshot(), sample => Assert.Equal((0, 0), (sample.A, sample.B)));
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Program)]
    public async Task Stop_goes_over_its_own_handle_while_the_feeder_waits_for_a_reply(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var links = new List<WithheldLink>();
        await using var session = await bench.OpenAsync(opened: links.Add);
        using var stop = new CancellationTokenSource();
        var running = JobRunner.RunAsync(
            MotionPrograms.LongLine(200000), session, SimulatedBench.Job with { Strategy = mode.Strategy() }, new CancelWhen(progress => progress.X > 50000, links[0].Withhold), stop.Token);
        await links[0].HasWaiter;

        var braked = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        var answers = 0;
        links[1].Repair = text =>
        {
            answers += text.Count(sign => sign == ':');
            if (answers == 4) braked.TrySetResult(); // the whole stop in one line; CB, STS and ST of the second pass
            return text;
        };
        await stop.CancelAsync();
        var pressedAt = bench.Controller.Status.Sample;
        var atOnce = bench.Controller.Status.Outputs;
        var rests = bench.Controller.AdvanceUntil(status => !status.IsMoving, TimeSpan.FromSeconds(0.5));
        var feederWaits = !running.IsCompleted;
        await braked.Task;
        bench.Controller.Advance(new SessionOptions().ReplyTimeout);

        Assert.Equal((0, true, true), (atOnce, rests, feederWaits));
        Assert.Equal(new CountsPoint(bench.Last.A, bench.Last.B), (await running).FinalPosition);
        CutRecord.AssertSafeAfter(bench, pressedAt, toolSeconds: 0.01, restSeconds: 0.5);
    }

    /// <summary>A job tests its stop handle from time to time. If that reply is late or lost, the stop does not wait for it.</summary>
    [Fact]
    public async Task Stop_is_on_the_wire_at_once_while_its_own_handle_waits_for_an_answer()
    {
        await using var bench = new SimulatedBench();
        var links = new List<WithheldLink>();
        await using var session = await bench.OpenAsync(opened: links.Add);
        using var stop = new CancellationTokenSource();
        var trial = new CancelWhen(progress => progress.X > 50000, () =>
        {
            links[1].Withhold();
            _ = session.CheckStopHandleAsync(CancellationToken.None);
            links[0].Withhold(); // the feeder waits as well: time must not pass before the press
        });
        var running = JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, SimulatedBench.Job, trial, stop.Token);
        await links[1].HasWaiter;
        await links[0].HasWaiter;

        await stop.CancelAsync();
        var atOnce = bench.Controller.Status.Outputs;
        var rests = bench.Controller.AdvanceUntil(status => !status.IsMoving, TimeSpan.FromSeconds(0.5));
        while (!running.IsCompleted)
        {
            bench.Controller.Advance(TimeSpan.FromSeconds(1)); // both handles count as lost
            await Task.Yield();
        }

        Assert.Equal((0, true, JobOutcome.LinkLost), (atOnce, rests, (await running).Outcome));
    }

    /// <summary>A serial line has one channel: the reply to a poll or a segment may be late there as well.</summary>
    [Fact]
    public async Task Stop_over_a_serial_line_is_on_the_wire_at_once_while_an_answer_is_late()
    {
        await using var bench = new SimulatedBench();
        var link = new WithheldLink(bench.OpenSerialLink(19200));
        await using var session = await ControllerSession.OpenAsync(_ => Task.FromResult<IControllerLink>(link), new SessionOptions(), bench.Clock, CancellationToken.None);
        using var stop = new CancellationTokenSource();
        var trial = new CancelWhen(progress => progress.X > 50000, link.Withhold);
        var running = JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, SimulatedBench.Job, trial, stop.Token);
        await link.HasWaiter;

        await stop.CancelAsync();
        var atOnce = bench.Controller.Status.Outputs;
        var rests = bench.Controller.AdvanceUntil(status => !status.IsMoving, TimeSpan.FromSeconds(0.5));
        link.Release();

        Assert.Equal((0, true, JobOutcome.Stopped), (atOnce, rests, (await running).Outcome));
    }

    [Fact]
    public async Task Behind_an_urgent_line_every_command_has_its_own_answer()
    {
        await using var bench = new SimulatedBench();
        var links = new List<WithheldLink>();
        await using var session = await bench.OpenAsync(opened: links.Add);
        links[0].Withhold();
        var late = session.Commands.SendAsync("MG 1", CancellationToken.None).AsTask();

        await session.Commands.SendUrgentAsync("x=2;MG x");
        links[0].Release();

        Assert.Equal("1.0000", Assert.IsType<Accepted>(await late).Data);
        Assert.Equal("4.0000", Assert.IsType<Accepted>(await session.Commands.SendAsync("MG x+2", CancellationToken.None)).Data);
        await session.Commands.SendUrgentAsync("x=7"); // no command waits: it is sent in its turn
        Assert.Equal("2.0000", Assert.IsType<Accepted>(await session.Commands.SendAsync("MG x", CancellationToken.None)).Data);
    }

    [Fact]
    public async Task A_sequence_that_ran_dry_is_closed_by_the_stop()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        await bench.SendAsync("SHAB", "VMAB", "VP 100,0", "BGS");
        bench.Controller.Advance(TimeSpan.FromSeconds(1));
        Assert.True(bench.Controller.Status.IsSequenceOpen);

        var standstill = await new OperatorStop(session, [1], [], "AB").FinishAsync(TimeSpan.Zero, CancellationToken.None);

        Assert.Equal((100, 0), (standstill.Position.X, standstill.Position.Y));
        Assert.False(bench.Controller.Status.IsSequenceOpen);
    }

    [Fact]
    public async Task A_motion_that_is_begun_and_does_not_move_does_not_keep_the_stop_waiting()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync(opened: link => link.Corrupt = line => line.Replace("MG _BGS,_BGA", "MG _BGS,1", StringComparison.Ordinal));

        var standstill = await new OperatorStop(session, [1], [], "AB").FinishAsync(TimeSpan.Zero, CancellationToken.None).WaitAsync(TimeSpan.FromMinutes(1));

        Assert.Equal((0, 0), (standstill.Position.X, standstill.Position.Y));
    }

    private static (MotionProgram Program, int Far) Job(string place) => place switch
    {
        "line" => (MotionPrograms.LongLine(200000), 50000),
        "rapid" => (MotionPrograms.LongRapid(200000), 50000),
        "arcs" => (MotionPrograms.ArcChain(60, 1000), 31000),
        "short" => (MotionPrograms.ShortLines(1600), 40000),
        _ => throw new ArgumentOutOfRangeException(nameof(place)),
    };
}
