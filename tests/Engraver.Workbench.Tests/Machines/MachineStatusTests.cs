using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines;

public class MachineStatusTests
{
    private static readonly JobProgress s_told = new(2, 9, 7, 20, new CountsPoint(3000, 4000), true, 1.5, Outputs: 5);
    private static readonly MachineReading s_rest = new(default, default, IsMoving: false, MotorsOff: "");

    private static readonly Diagnostic s_nowhere = PreparationRules.ZeroLost.At(default, "G54");

    private static readonly MachineFacts s_idle = new() { Link = "tcp://a", Poll = s_rest };

    [Fact]
    public void Each_fact_has_its_state_and_the_graver_one_wins()
    {
        Assert.Equal(MachineState.Offline, State(MachineFacts.None));
        Assert.Equal(MachineState.Connected, State(s_idle with { Poll = null }));
        Assert.Equal(MachineState.Ready, State(s_idle));
        Assert.Equal(MachineState.MotorsOff, State(With(s_rest with { MotorsOff = "B" })));
        Assert.Equal(MachineState.Busy, State(With(s_rest with { MotorsOff = "B", IsProgramRunning = true })));
        Assert.Equal(MachineState.Busy, State(With(s_rest with { IsMoving = true })));
        Assert.Equal(MachineState.Fault, State(With(s_rest with { IsMoving = true, LostPosition = "A" })));
        Assert.Equal(MachineState.Fault, State(With(s_rest with { Limit = "the reverse limit of axis B" })));
        Assert.Equal(MachineState.EmergencyStopOpen, State(With(s_rest with { Limit = "the reverse limit of axis B", AbortInput = true })));
        Assert.Equal(MachineState.Fault, State(s_idle with { LinkFailure = "gone" }));
        Assert.Equal(MachineState.Running, State(s_idle with { LinkFailure = "gone", IsJobRunning = true }));
        Assert.Equal(MachineState.Stopping, State(s_idle with { IsJobRunning = true, IsStopping = true }));
        Assert.Equal(MachineState.NotHomed, State(s_idle with { IsHomed = false, OriginMissing = s_nowhere }));
        Assert.Equal(MachineState.NoOrigin, State(s_idle with { IsHomed = true, OriginMissing = s_nowhere }));
        Assert.Equal(MachineState.MotorsOff, State(With(s_rest with { MotorsOff = "A" }) with { OriginMissing = s_nowhere, IsHomed = false }));
    }

    [Fact]
    public void A_job_a_dry_run_a_hold_and_a_move_by_hand_are_states_of_their_own()
    {
        var runs = s_idle with { IsJobRunning = true };
        Assert.Equal(MachineState.Running, State(runs));
        Assert.Equal(MachineState.DryRun, State(runs with { IsDryRun = true }));
        Assert.Equal(MachineState.Holding, State(runs with { FeedHold = FeedHoldPhase.Braking }));
        Assert.Equal(MachineState.Held, State(runs with { FeedHold = FeedHoldPhase.Held }));
        Assert.Equal(MachineState.Stopping, State(runs with { FeedHold = FeedHoldPhase.Held, IsStopping = true }));
        Assert.Equal((MachineState.Moving, "a jog"), (State(runs with { MoveName = "a jog" }), Status(runs with { MoveName = "a jog", IsDryRun = true }).Reason));
        foreach (var dry in new[] { runs, runs with { FeedHold = FeedHoldPhase.Braking }, runs with { FeedHold = FeedHoldPhase.Held }, runs with { IsStopping = true } })
            Assert.Contains("dry run", Status(dry with { IsDryRun = true }).Reason, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(JobOutcome.Complete, MachineState.Complete, "")]
    [InlineData(JobOutcome.Deviated, MachineState.Deviated, "the cut deviates from the drawing; see the alarm")]
    [InlineData(JobOutcome.Stopped, MachineState.Stopped, "stopped by the operator")]
    [InlineData(JobOutcome.LinkLost, MachineState.Stopped, "connection lost")]
    [InlineData(JobOutcome.Refused, MachineState.Stopped, "refused by the controller")]
    public void How_a_job_ended_is_the_state_until_the_job_is_history(JobOutcome outcome, MachineState state, string reason)
    {
        var ended = s_idle with { Ended = outcome, Progress = s_told, LastProgress = s_told };
        Assert.Equal((state, reason, 7), (Status(ended).State, Status(ended).Reason, Status(ended).Progress!.SegmentsDone));
        Assert.True(state.IsReady());
    }

    [Fact]
    public void Progress_never_stands_under_ready_armed_or_a_missing_origin()
    {
        var job = JobPreparation.Prepare(new DrawingBuilder().Line(0, 0, 1, 0).Build(), new DrawingSettings(), MotionStyle.Continuous);
        var armed = new ArmedJob(job, JobMode.Stream.Strategy(), true, new ArmingChecklist([]), DateTimeOffset.UnixEpoch);
        var old = s_idle with { Progress = s_told, LastProgress = s_told };
        Assert.Equal((MachineState.Ready, null), (Status(old).State, Status(old).Progress));
        Assert.Equal((MachineState.NoOrigin, null), (State(old with { OriginMissing = s_nowhere }), Status(old with { OriginMissing = s_nowhere }).Progress));
        var waiting = (old with { Ended = JobOutcome.Stopped }).ToStatus(MachineProfile.Default, armed);
        Assert.Equal((MachineState.Armed, null, true, "dry run: the tool stays off"), (waiting.State, waiting.Progress, waiting.IsDryRun, waiting.Reason));
    }

    [Fact]
    public void Every_state_has_its_words_for_people_and_for_programs()
    {
        var states = Enum.GetValues<MachineState>();
        Assert.Equal(states.Length, states.Select(state => state.Token()).Distinct().Count());
        Assert.All(states, state => Assert.Equal(state.Token(), state.DisplayText()));
        Assert.All(states, state => Assert.Equal(state.Token().ToUpperInvariant(), state.Token()));
    }

    [Fact]
    public void What_is_armed_is_armed_only_at_a_machine_that_is_ready()
    {
        var job = JobPreparation.Prepare(new DrawingBuilder().Line(0, 0, 1, 0).Build(), new DrawingSettings(), MotionStyle.Continuous);
        var armed = new ArmedJob(job, JobMode.Stream.Strategy(), false, new ArmingChecklist([]), DateTimeOffset.UnixEpoch);

        Assert.Equal((MachineState.Armed, armed.Until), (s_idle.ToStatus(MachineProfile.Default, armed).State, s_idle.ToStatus(MachineProfile.Default, armed).ArmedUntil));
        var off = With(s_rest with { MotorsOff = "A" }).ToStatus(MachineProfile.Default, armed);
        Assert.Equal((MachineState.MotorsOff, null), (off.State, off.ArmedUntil));
    }

    [Fact]
    public void Counts_become_millimetres_of_the_profile_with_its_mirrored_axis()
    {
        var profile = MachineProfile.Default with { Axes = MachineAxes.FromScale(-500, 2000), ToolOutput = 3 };
        var status = (With(new MachineReading(new CountsPoint(1000, 4000), new CountsPoint(5, -20), false, "") { Outputs = 4, Speed = 2000, Inputs = 255 }) with { Frame = new CountsPoint(500, 2000) }).ToStatus(profile, null);

        Assert.Equal((-2.0, 2.0), (status.MachinePosition!.Value.X, status.MachinePosition.Value.Y));
        Assert.Equal((-1.0, 1.0), (status.WorkPosition!.Value.X, status.WorkPosition.Value.Y));
        Assert.Equal((-0.01, -0.01), (status.FollowingError!.Value.X, status.FollowingError.Value.Y));
        Assert.Equal((true, 0.0, 255), (status.ToolCommanded!.Value, status.Speed!.Value, status.Inputs!.Value));
    }

    [Fact]
    public void While_a_job_runs_the_place_is_what_the_job_says()
    {
        var facts = s_idle with { IsJobRunning = true, Frame = new CountsPoint(10_000, 0), Progress = s_told, LastProgress = s_told };
        var status = facts.ToStatus(MachineProfile.Default, null);

        Assert.Equal((13.0, 3.0, 4.0), (status.MachinePosition!.Value.X, status.WorkPosition!.Value.X, status.WorkPosition.Value.Y));
        Assert.Equal((2, 7, 0.35), (status.Progress!.Stroke, status.Progress.SegmentsDone, status.Progress.Fraction));
        Assert.Equal((true, 5, null), (status.ToolCommanded!.Value, status.Outputs!.Value, status.Inputs));
    }

    /// <summary>The last poll was before the job: it has neither the current position nor the tool state.</summary>
    [Fact]
    public void Once_the_link_is_lost_only_the_last_place_is_known()
    {
        var watched = With(s_rest with { Position = new CountsPoint(7000, 0), Outputs = 0, Inputs = 255, Speed = 0.0 }) with { LinkFailure = "gone" };
        var told = watched with { IsPollStale = true, Frame = new CountsPoint(10_000, 0), Progress = s_told, LastProgress = s_told };
        foreach (var (facts, x) in new[] { (watched, 7.0), (told, 13.0) })
        {
            var status = facts.ToStatus(MachineProfile.Default, null);
            Assert.Equal(x, status.MachinePosition!.Value.X);
            Assert.Equal((null, null, null, null, null, null), (status.ToolCommanded, status.Outputs, status.Inputs, status.Speed, status.MotorsOn, status.FollowingError));
        }

        Assert.Equal(13.0, (told with { LinkFailure = null }).ToStatus(MachineProfile.Default, null).MachinePosition!.Value.X);
    }

    /// <summary>A poll that was under way when the motion started arrives late.</summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_poll_from_before_a_motion_does_not_replace_the_position_at_its_end(bool isKeptReady)
    {
        using var model = new MachineStatusModel(new ManualTimeProvider(), () => { });
        model.Connected("tcp://a", isSimulation: false, new MachineIdentity("DMC2143", 4));
        model.Polled(s_rest);
        model.MoveStarted("a jog");
        model.Polled(s_rest);
        if (!isKeptReady) model.WatchPaused();
        model.MoveProgressed(s_told);
        if (isKeptReady)
        {
            model.ClearJog();
        }
        else
        {
            model.LinkLost(new ControllerLinkException("Nobody answers."));
            model.ClearJob();
        }

        Assert.Equal(3.0, model.Status.MachinePosition!.Value.X);
        model.Polled(s_rest with { Position = new CountsPoint(7000, 0) });
        Assert.Equal(7.0, model.Status.MachinePosition!.Value.X);
    }

    private static MachineFacts With(MachineReading poll) => s_idle with { Poll = poll };

    private static MachineStatus Status(MachineFacts facts) => facts.ToStatus(MachineProfile.Default, null);

    private static MachineState State(MachineFacts facts) => facts.ToStatus(MachineProfile.Default, null).State;
}
