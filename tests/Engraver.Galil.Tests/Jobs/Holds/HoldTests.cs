using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>HOLD brakes on the path and switches the tool off at rest; RESUME continues from the same position. Checked by the simulator's record.</summary>
public class HoldTests
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
    public async Task A_held_cut_stands_with_the_tool_off_and_goes_on_where_it_stood(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongLine(100000);
        var operators = new HoldingOperator(bench, at: now => now.X > 30000, heldSeconds: 20.0);

        var result = await RunAsync(bench, program, mode, baud, operators);

        Assert.Equal((JobOutcome.Complete, 1, 1), (result.Outcome, result.SegmentsExecuted, result.Holds));
        CutRecord.AssertWholePathWasCut(bench, program);
        HoldRecord.AssertAtRestInHold(bench, operators);
        HoldRecord.AssertNoRepeatedCut(bench, program, 0.0);
        HoldRecord.AssertNoBurnAtRest(bench, program.Profile);
        Assert.Equal([JobPhase.Holding, JobPhase.Held, JobPhase.Resuming, JobPhase.Running], operators.Phases.Take(4));
    }

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task A_hold_in_a_rapid_lets_it_end_and_begins_nothing_behind_it(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongRapid(60000);
        var operators = new HoldingOperator(bench, at: now => now.X > 5000, heldSeconds: 20.0);

        var result = await RunAsync(bench, program, mode, baud, operators);

        Assert.Equal((JobOutcome.Complete, 1), (result.Outcome, result.Holds));
        CutRecord.AssertWholePathWasCut(bench, program);
        HoldRecord.AssertAtRestInHold(bench, operators);
        Assert.Equal((60000, 60000), (operators.HeldAt.X, operators.HeldAt.Y));
        HoldRecord.AssertNoBurnAtRest(bench, program.Profile);
    }

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task A_stop_wins_over_a_hold(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();
        var operators = new HoldingOperator(bench, at: now => now.X > 30000, heldSeconds: 1.0) { WhenHeld = stop.Cancel };

        var result = await RunAsync(bench, MotionPrograms.LongLine(100000), mode, baud, operators, stop: stop.Token);

        Assert.Equal(JobOutcome.Stopped, result.Outcome);
        Assert.Equal((0, 0, false), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads, bench.Controller.Status.IsMoving));
        Assert.True(result.IsEndKnown);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Program)]
    public async Task Holds_in_many_short_segments_leave_nothing_out(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.ShortLines(1500);
        var operators = new HoldingOperator(bench, at: _ => true, heldSeconds: 2.0) { Repeats = 12, Between = 0.35 };

        var result = await RunAsync(bench, program, mode, Network, operators);

        Assert.Equal((JobOutcome.Complete, 1500), (result.Outcome, result.SegmentsExecuted));
        Assert.InRange(result.Holds, 8, 13);
        CutRecord.AssertWholePathWasCut(bench, program);
        HoldRecord.AssertNoRepeatedCut(bench, program, 0.0);
        HoldRecord.AssertNoBurnAtRest(bench, program.Profile);
    }

    [Theory]
    [InlineData(JobMode.Stream, JobPhase.Held, "and is now at")]
    [InlineData(JobMode.Program, JobPhase.Held, "and is now at")]
    [InlineData(JobMode.Calls, JobPhase.Holding, "did not stop")]
    [InlineData(JobMode.Stream, JobPhase.Holding, "did not stop")]
    public async Task Somebody_else_who_sets_the_path_in_motion_again_ends_the_job(JobMode mode, JobPhase phase, string said)
    {
        await using var bench = new SimulatedBench();
        var operators = new HoldingOperator(bench, at: now => now.X > 20000, heldSeconds: 30.0);
        var stranger = new WhileIn(phase, () => bench.Interfere("VR 1"));

        var result = await RunAsync(bench, MotionPrograms.LongLine(300000), mode, Network, operators, also: stranger);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains(said, result.Message, StringComparison.Ordinal);
        Assert.Equal((0, 0, false), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads, bench.Controller.Status.IsMoving));
    }

    /// <summary>Acts at every report of a phase.</summary>
    private sealed class WhileIn(JobPhase phase, Action act) : IProgress<JobProgress>
    {
        public void Report(JobProgress value)
        {
            if (value.Phase == phase) act();
        }
    }

    [Fact]
    public async Task A_hold_before_the_start_begins_nothing_until_it_is_taken_back()
    {
        await using var bench = new SimulatedBench();
        var operators = new HoldingOperator(bench, at: _ => true, heldSeconds: 5.0);
        operators.Control.Hold();

        var result = await RunAsync(bench, MotionPrograms.Paper, JobMode.Stream, Network, operators);

        Assert.Equal((JobOutcome.Complete, 4), (result.Outcome, result.SegmentsExecuted));
        Assert.Equal((0, 0), (operators.HeldAt.X, operators.HeldAt.Y));
        CutRecord.AssertWholePathWasCut(bench, MotionPrograms.Paper);
    }

    /// <summary>A spindle that stops in a hold gives up what is held. Another host starts a sequence while the job is prepared: it is given up before the job's
    /// own first motion.</summary>
    [Fact]
    public async Task A_hold_that_gives_up_a_motion_in_the_preparation_ends_the_job_as_stopped()
    {
        await using var bench = new SimulatedBench();
        var profile = MachineProfile.Default with { Spindle = new Spindle { Output = 3, SpinUpSeconds = 0.4, StopsInHold = true } };
        var (control, isStarted) = (new JobControl(), false);
        control.Hold();
        await using var session = await bench.OpenAsync(opened: link => link.Sending = line =>
        {
            if (isStarted || !line.StartsWith("XQ", StringComparison.Ordinal)) return;
            isStarted = true;
            bench.Interfere("VMAB;VP 200000,0;VE;BGS");
        });

        var result = await JobRunner.RunAsync(MotionPrograms.Paper with { Profile = profile }, session, SimulatedBench.Job with { Control = control }, null, CancellationToken.None);

        Assert.Equal((JobOutcome.Stopped, "Stopped by the operator.", 0, 1), (result.Outcome, result.Message, result.SegmentsExecuted, result.Holds));
        Assert.True(bench.Controller.Status.IsIdle);
        Assert.InRange(bench.Last.A, 1, 199_999); // the sequence of the other host had started and was ended
    }

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task A_dry_run_is_held_with_the_tool_off_throughout(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var operators = new HoldingOperator(bench, at: now => now.X > 30000, heldSeconds: 8.0);

        var result = await RunAsync(bench, MotionPrograms.LongLine(100000), mode, baud, operators, dryRun: true);

        Assert.Equal((JobOutcome.Complete, 1), (result.Outcome, result.Holds));
        Assert.DoesNotContain(bench.Controller.Record.Snapshot(), sample => sample.Outputs != 0);
    }

    internal static async Task<JobResult> RunAsync(SimulatedBench bench, MotionProgram program, JobMode mode, int baud, HoldingOperator operators, bool dryRun = false, IProgress<JobProgress>? also = null, string? journal = null, CancellationToken stop = default)
    {
        await using var session = baud == Network ? await bench.OpenAsync() : await bench.OpenSerialAsync(baud);
        return await JobRunner.RunAsync(program, session, SimulatedBench.Job with { Strategy = mode.Strategy(), Control = operators.Control, DryRun = dryRun, JournalPath = journal }, also is null ? operators : new ProgressPair(operators, also), stop);
    }
}
