using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Jobs;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;
using Engraver.Galil.Tests.Links;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>During a hold the machine can be moved by hand within its travel; RESUME returns to the position, and after a stop, a lost host or a limit switch
/// in between the whole drawing is still cut. Checked by the simulator's record.</summary>
public sealed class HeldMoveTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("held-move").FullName;

    public static TheoryData<JobMode, bool> Machines => new()
    {
        { JobMode.Stream, false },
        { JobMode.Calls, false },
        { JobMode.Program, false },
        { JobMode.Stream, true },
        { JobMode.Calls, true },
        { JobMode.Program, true },
    };

    [Theory]
    [MemberData(nameof(Machines))]
    public async Task Jogged_away_by_steps_and_by_a_held_key_it_comes_back_and_goes_on(JobMode mode, bool isAxis)
    {
        await using var bench = new SimulatedBench();
        var program = Program(mode, isAxis);
        var key = new JogControl(new JogVelocity(-600.0, 0.0));
        var operators = new MovingOperator(Cutting(isAxis), now => now.X < -8000, MoveInHold.To(new CountsPoint(-5000, 70000), withHeight: false), MoveInHold.By(new CountsPoint(500, -2000, 0)), MoveInHold.While(key));

        var result = await RunAsync(bench, program, mode, operators);
        var moves = await Task.WhenAll(operators.Moves);

        Assert.Equal((JobOutcome.Complete, program.SegmentCount, 1), (result.Outcome, result.SegmentsExecuted, result.Holds));
        Assert.All(moves, move => Assert.Equal(JobOutcome.Complete, move.Outcome));
        Assert.Equal([new CountsPoint(-5000, 70000), new CountsPoint(-4500, 68000)], moves.Take(2).Select(move => move.FinalPosition!.Value with { Z = 0 }));
        Assert.InRange(moves[2].FinalPosition!.Value.X, -12000, -8000);
        Assert.Equal([JobPhase.Held], operators.PhasesMeanwhile);
        AssertCut(bench, program);
        Assert.Contains(bench.Controller.Record.Snapshot(), sample => (sample.A, sample.B) == (-4500, 68000));
    }

    [Theory]
    [MemberData(nameof(Machines))]
    public async Task A_step_out_of_the_travel_is_refused_a_held_key_ends_at_its_end_and_the_job_goes_on(JobMode mode, bool isAxis)
    {
        await using var bench = new SimulatedBench();
        var plain = Program(mode, isAxis);
        var axes = plain.Profile.Axes;
        var program = plain with { Profile = plain.Profile with { Axes = axes with { X = axes.X with { Travel = new AxisTravel(-90.0, 1200.0) }, Y = axes.Y with { Travel = new AxisTravel(-90.0, 700.0) } } } };
        var operators = new MovingOperator(Cutting(isAxis), _ => false, MoveInHold.By(new CountsPoint(-200000, 0)), MoveInHold.While(new JogControl(new JogVelocity(0.0, -2500.0))));

        var result = await RunAsync(bench, program, mode, operators, TravelLimits.Of(program.Profile));
        var moves = await Task.WhenAll(operators.Moves);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.Equal((JobOutcome.Refused, "JOB0030", JobOutcome.Complete), (moves[0].Outcome, moves[0].Diagnostics.Single().Id, moves[1].Outcome));
        Assert.Equal(TravelLimits.Of(axes.Y with { Travel = new AxisTravel(-90.0, 700.0) })!.Value.Min, moves[1].FinalPosition!.Value.Y);
        AssertCut(bench, program);
    }

    [Theory]
    [MemberData(nameof(Machines))]
    public async Task A_stop_while_it_is_jogged_away_is_resumed_at_the_place_where_it_was_held(JobMode mode, bool isAxis)
    {
        await using var bench = new SimulatedBench();
        var program = Program(mode, isAxis);
        using var stop = new CancellationTokenSource();
        var operators = new MovingOperator(Cutting(isAxis), _ => false, MoveInHold.To(new CountsPoint(20000, 30000), withHeight: false)) { WhenMoved = stop.Cancel };

        var first = await RunAsync(bench, program, mode, operators, journal: "a", stop: stop.Token);
        var second = await ResumeAsync(bench, program, mode, "a", "b");

        Assert.Equal((JobOutcome.Stopped, new CountsPoint(20000, 30000)), (first.Outcome, first.FinalPosition!.Value with { Z = 0 }));
        Assert.Equal((JobOutcome.Complete, program.SegmentCount), (second.Outcome, second.SegmentsExecuted));
        AssertCut(bench, program);
    }

    [Theory]
    [MemberData(nameof(Machines))]
    public async Task A_host_that_dies_while_a_key_is_held_brakes_within_the_dead_mans_time_and_is_resumed_at_the_place(JobMode mode, bool isAxis)
    {
        await using var bench = new SimulatedBench();
        var program = Program(mode, isAxis);
        var (died, diedAt) = (false, 0L);
        var operators = new MovingOperator(Cutting(isAxis), _ => false, MoveInHold.While(new JogControl(new JogVelocity(1500.0, 0.0))))
        {
            WhileMoving = now =>
            {
                if (died || now.X < 45000) return;
                (died, diedAt) = (true, bench.Controller.Status.Sample);
                bench.Controller.DropConnections();
                bench.Controller.Advance(TimeSpan.FromSeconds(3));
            },
        };

        var first = await RunAsync(bench, program, mode, operators, journal: "a");
        var moves = await Task.WhenAll(operators.Moves);
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));
        var record = bench.Controller.Record.Snapshot();
        var lastMove = record.Zip(record.Skip(1)).Last(pair => pair.First.A != pair.Second.A).Second.Sample;
        var second = await ResumeAsync(bench, program, mode, "a", "b");

        Assert.Equal(JobOutcome.LinkLost, first.Outcome);
        Assert.InRange(lastMove - diedAt, 1, 500);
        Assert.Equal(JobOutcome.LinkLost, moves.Single().Outcome);
        Assert.Equal((JobOutcome.Complete, program.SegmentCount), (second.Outcome, second.SegmentsExecuted));
        AssertCut(bench, program);
    }

    [Theory]
    [MemberData(nameof(Machines))]
    public async Task A_limit_switch_ends_the_move_and_not_the_job(JobMode mode, bool isAxis)
    {
        await using var bench = new SimulatedBench();
        var program = Program(mode, isAxis);
        var pressed = false;
        var operators = new MovingOperator(Cutting(isAxis), _ => false, MoveInHold.While(new JogControl(new JogVelocity(1500.0, 0.0))), MoveInHold.By(new CountsPoint(-3000, 0)))
        {
            WhileMoving = now =>
            {
                if (!pressed && now.X > 45000) bench.Controller.SetLimitSwitch(0, forward: true, active: pressed = true);
                else if (pressed && now.X < 45000) bench.Controller.SetLimitSwitch(0, forward: true, active: false);
            },
        };

        var result = await RunAsync(bench, program, mode, operators);
        var moves = await Task.WhenAll(operators.Moves);

        Assert.Equal((JobOutcome.Refused, JobOutcome.Complete), (moves[0].Outcome, moves[1].Outcome));
        Assert.Contains("limit", moves[0].Message, StringComparison.Ordinal);
        Assert.Equal(JobOutcome.Complete, result.Outcome);
        AssertCut(bench, program);
    }

    [Theory]
    [MemberData(nameof(Machines))]
    public async Task A_move_that_is_asked_for_just_before_the_resume_is_not_made_at_the_next_hold(JobMode mode, bool isAxis)
    {
        await using var bench = new SimulatedBench();
        var program = Program(mode, isAxis);
        var late = default(Task<JobResult>);
        var holds = 0;
        var operators = default(MovingOperator);
        operators = new MovingOperator(Cutting(isAxis), _ => false)
        {
            WhenMoved = () =>
            {
                if (holds++ == 0) late = operators!.Control.MoveAsync(MoveInHold.By(new CountsPoint(7777, -9999)));
                operators!.Control.Resume();
            },
        };
        var again = new CancelWhen(now => late is not null && now.Phase == JobPhase.Running && now.ToolOn, operators.Control.Hold);

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy(), Control = operators.Control, Frame = default(CountsPoint) }, new ProgressPair(operators, again));

        Assert.Equal((JobOutcome.Complete, 2), (result.Outcome, result.Holds));
        Assert.Equal(JobOutcome.Refused, (await late!).Outcome);
        AssertCut(bench, program);
        var held = operators.HeldAt;
        Assert.DoesNotContain(bench.Controller.Record.Snapshot(), sample => Math.Abs(sample.A - held.X - 7777) < 3 && Math.Abs(sample.B - held.Y + 9999) < 3);
    }

    /// <summary>A pen that is raised for inspection, or lowered, is back at the height of the cut before anything is cut, and moves up or down with the tool
    /// off.</summary>
    [Theory]
    [InlineData(JobMode.Stream, 4000)]
    [InlineData(JobMode.Calls, 4000)]
    [InlineData(JobMode.Program, 4000)]
    [InlineData(JobMode.Stream, -1600)]
    [InlineData(JobMode.Program, -1600)]
    public async Task The_height_of_a_tool_that_an_output_switches_is_brought_back_too(JobMode mode, int up)
    {
        await using var bench = new SimulatedBench();
        var program = Pen();
        var operators = new MovingOperator(Cutting(isAxis: false), _ => false, MoveInHold.By(new CountsPoint(0, 0, up)), MoveInHold.By(new CountsPoint(500, -2000, 0)));

        var result = await RunAsync(bench, program, mode, operators);

        Assert.Equal((JobOutcome.Complete, program.SegmentCount, 1), (result.Outcome, result.SegmentsExecuted, result.Holds));
        AssertCutAtItsHeight(bench, program, up);
        var record = bench.Controller.Record.Snapshot();
        var back = record.SkipWhile(sample => sample.C != up).Where(sample => sample.C != up && sample.C != 0).ToList();
        Assert.NotEmpty(back);
        Assert.All(back, sample => Assert.Equal(up > 0 ? 0 : -2000, sample.B)); // up before the move, down after it
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task Held_and_moved_again_on_the_way_back_it_still_knows_the_height_of_the_cut(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = Pen();
        var (stage, again) = (0, default(Task<JobResult>));
        var operators = default(MovingOperator);
        operators = new MovingOperator(Cutting(isAxis: false), _ => false, MoveInHold.By(new CountsPoint(500, -20000, 4000)))
        {
            WhenMoved = () =>
            {
                if (stage == 1) again = operators!.Control.MoveAsync(MoveInHold.By(new CountsPoint(0, 0, 1000)));
                else if (stage == 0 || again!.IsCompleted) operators!.Control.Resume();
                stage++;
            },
        };
        var onTheWay = new CancelWhen(now => stage == 1 && now.Phase != JobPhase.Held && now.Place.Y is > -15000 and < -1000, operators.Control.Hold);

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy(), Control = operators.Control, Frame = default(CountsPoint) }, new ProgressPair(onTheWay, operators));

        Assert.Equal((JobOutcome.Complete, 2), (result.Outcome, result.Holds));
        Assert.Equal(JobOutcome.Complete, (await again!).Outcome);
        AssertCutAtItsHeight(bench, program, 5000);
    }

    /// <summary>A pen is raised for inspection, or lowered, during a hold, and then the job is stopped: the job that resumes it returns the pen to the height
    /// of the cut; also a third one, which resumes that job.</summary>
    [Theory]
    [InlineData(JobMode.Stream, 4000)]
    [InlineData(JobMode.Calls, 4000)]
    [InlineData(JobMode.Program, 4000)]
    [InlineData(JobMode.Stream, -1600)]
    public async Task Stopped_with_the_pen_at_another_height_it_is_resumed_at_the_height_of_the_cut(JobMode mode, int up)
    {
        await using var bench = new SimulatedBench();
        var program = Pen();
        using var stop = new CancellationTokenSource();
        var operators = new MovingOperator(Cutting(isAxis: false), _ => false, MoveInHold.By(new CountsPoint(0, 0, up))) { WhenMoved = stop.Cancel };
        Assert.Equal(JobOutcome.Stopped, (await RunAsync(bench, program, mode, operators, journal: "raised", stop: stop.Token)).Outcome);
        Assert.Equal(up, bench.Last.C);
        using var again = new CancellationTokenSource();
        var second = await ResumeAsync(bench, program, mode, "raised", "second", new CancelWhen(now => now.X > 30000, again.Cancel), again.Token);

        var result = await ResumeAsync(bench, program, mode, "second", "third");

        Assert.Equal((JobOutcome.Stopped, JobOutcome.Complete, program.SegmentCount), (second.Outcome, result.Outcome, result.SegmentsExecuted));
        AssertCutAtItsHeight(bench, program, up);
    }

    /// <summary>The cable is cut just when the held sequence has been ended, which the server in the controller treats as the end of its call: the rest of this
    /// call is cut by the job that resumes it.</summary>
    [Theory]
    [MemberData(nameof(Machines))]
    public async Task A_link_that_is_cut_as_the_held_sequence_is_given_up_loses_nothing(JobMode mode, bool isAxis)
    {
        await using var bench = new SimulatedBench();
        var program = Program(mode, isAxis);
        var (links, isEnded) = (new List<WithheldLink>(), false);
        var operators = new MovingOperator(Cutting(isAxis), _ => false, MoveInHold.By(new CountsPoint(0, -1000)));
        await using (var session = await bench.OpenAsync(opened: links.Add))
        {
            links[0].Sending = line =>
            {
                if (isEnded) bench.Controller.DropConnections();
                isEnded |= line.StartsWith("STS", StringComparison.Ordinal);
            };
            var lost = await JobRunner.RunAsync(program, session, SimulatedBench.Job with { Strategy = mode.Strategy(), Control = operators.Control, Frame = default(CountsPoint), Address = "bench", JournalPath = PathOf("cut") }, operators, CancellationToken.None);
            Assert.Equal((JobOutcome.LinkLost, true), (lost.Outcome, isEnded));
        }

        bench.Controller.Advance(TimeSpan.FromSeconds(6)); // the watchdog trips, and a tool that is moved by an axis is raised
        var result = await ResumeAsync(bench, program, mode, "cut", "rest");

        Assert.Equal((JobOutcome.Complete, program.SegmentCount), (result.Outcome, result.SegmentsExecuted));
        AssertCut(bench, program);
    }

    [Fact]
    public async Task A_job_that_is_not_held_lets_nobody_move_the_machine()
    {
        var control = new JobControl();
        var running = await control.MoveAsync(MoveInHold.By(new CountsPoint(100, 0)));
        control.Hold();
        control.Enter(JobPhase.Held);
        var first = control.MoveAsync(MoveInHold.By(new CountsPoint(100, 0)));
        var second = await control.MoveAsync(MoveInHold.By(new CountsPoint(100, 0)));
        control.Complete(JobResult.NotStarted(0, "over"));

        Assert.Contains("job is not held", running.Message, StringComparison.Ordinal);
        Assert.Contains("manual move is not finished", second.Message, StringComparison.Ordinal);
        Assert.Equal("over", (await first).Message);
        Assert.Contains("job is not held", (await control.MoveAsync(MoveInHold.By(new CountsPoint(1, 0)))).Message, StringComparison.Ordinal);
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private static MotionProgram Program(JobMode mode, bool isAxis) => isAxis ? HeightBench.Part(style: mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous) : MotionPrograms.LongLine(40000);

    private static MotionProgram Pen()
    {
        var line = MotionPrograms.LongLine(40000);
        return line with { Profile = line.Profile with { Axes = line.Profile.Axes with { Z = new MachineAxis('C', 800.0) } } };
    }

    private static void AssertCutAtItsHeight(SimulatedBench bench, MotionProgram program, int away)
    {
        AssertCut(bench, program);
        var record = bench.Controller.Record.Snapshot();
        Assert.Contains(record, sample => sample.C == away);
        Assert.All(record.Where(sample => sample.Outputs != 0), sample => Assert.Equal(0, sample.C));
    }

    private static Func<JobProgress, bool> Cutting(bool isAxis) => isAxis ? HeightHoldTests.At("slope") : now => now.X > 20000;

    private static void AssertCut(SimulatedBench bench, MotionProgram program)
    {
        if (program.Profile.Height is not null)
        {
            HeightBench.AssertCut(bench, program, most: 1500.0);
            return;
        }

        HoldRecord.AssertEverythingWasCut(bench, program);
        HoldRecord.AssertNoRepeatedCut(bench, program, most: 1500.0);
    }

    private Task<JobResult> RunAsync(SimulatedBench bench, MotionProgram program, JobMode mode, MovingOperator operators, IReadOnlyList<SoftLimit>? limits = null, string? journal = null, CancellationToken stop = default) =>
        bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy(), Control = operators.Control, SoftLimits = limits ?? [], Frame = default(CountsPoint), Address = "bench", JournalPath = journal is null ? null : PathOf(journal) }, operators, stop);

    private async Task<JobResult> ResumeAsync(SimulatedBench bench, MotionProgram program, JobMode mode, string journal, string next, IProgress<JobProgress>? progress = null, CancellationToken stop = default)
    {
        ResumePosition found;
        await using (var session = await bench.OpenAsync()) found = await ResumeFinder.FindAsync(session.Commands, program, mode, PathOf(journal), CancellationToken.None);
        Assert.Equal((null, true), (found.Refusal, found.IsSameZero));
        return await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy(), JournalPath = PathOf(next), Frame = default(CountsPoint), Address = "bench", From = found.Place, LeadIn = 500.0 + found.Doubt, HeightOfCut = found.HeightOfCut }, progress, stop);
    }

    private string PathOf(string name) => Path.Combine(_folder, name + ".jsonl");
}
