using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Resident;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>What a job does about its <see cref="JobControl"/>: it holds, resumes and puts overrides in force. It is called after every poll, so that
/// every wait of every execution strategy can be held.</summary>
/// <remarks>
/// A running sequence is held by VR 0 (galil-dmc.md B.8): its segments stay in the buffer, and polls, heartbeat and watchdog continue. The tool is
/// switched off when the path is at standstill. VR does not affect a rapid, which is completed; what follows it waits at a gate: of this computer before a
/// rapid, a tool or a call, or, where a program runs the job, of that program after its rapid.
/// Where an axis drives the tool, and where the operator moves the machine by hand, what is held is given up (<see cref="HeldMotion"/>): its axes are then
/// free. The job remains held in <see cref="AwayAsync"/> and then cuts the rest.
/// </remarks>
internal sealed class JobHold(JobMachine machine, JobControl control, JobLog log, IReadOnlyList<SoftLimit> limits)
{
    /// <summary>After VR is restored the path moves within this many samples, or it does not move at all.</summary>
    private const int SamplesToMove = 50;

    private bool _isAttending;
    private bool _isReturning;

    /// <summary>What the operator sees of a hold.</summary>
    public JobPhase Phase { get; private set; }

    /// <summary>How often the machine was held at standstill.</summary>
    public int Holds { get; private set; }

    /// <summary>The operator requests something that is not in force yet.</summary>
    public bool IsRequested => !_isAttending && machine.Speed.IsChangeRequested;

    /// <summary>The operator requests that the job is held, or it is.</summary>
    public bool IsHoldWanted => control.IsHoldWanted;

    /// <summary>A path that still runs this long after VR 0 does not obey it: twice the longest ramp, and two seconds.</summary>
    private double SamplesToBrake => 1000.0 * (2.0 + (2.0 * JobControl.FeedRange.Max * machine.Profile.VectorSpeed() / machine.Profile.AccelerationCounts));

    /// <summary>Call after every poll: holds, or puts an override in force.</summary>
    public async ValueTask AttendAsync()
    {
        if (!IsRequested || machine.IsStopped) return;
        _isAttending = true;
        try
        {
            if (!control.IsHoldWanted) await AdjustAsync().ConfigureAwait(false);
            else if (machine.Phase.HoldPointAt(machine.State) != HoldPoint.AtGate) await HoldAsync().ConfigureAwait(false);
        }
        finally
        {
            _isAttending = false;
        }
    }

    /// <summary>Call where the machine is at rest with the tool off and something is about to begin: waits while the job is held.</summary>
    public async ValueTask GateAsync()
    {
        if (!control.IsHoldWanted || _isAttending) return;
        _isAttending = true;
        try
        {
            await StayAsync().ConfigureAwait(false);
            Enter(JobPhase.Running); // the caller sends what comes next with the ratio that is requested then
        }
        finally
        {
            _isAttending = false;
        }
    }

    /// <summary>Tool on where the next motion begins at once; a hold meanwhile switches it off again and is waited for.</summary>
    /// <param name="at">Where the motion begins, job frame.</param>
    public async ValueTask ToolOnAsync(CountsPoint at)
    {
        do
        {
            if (control.IsHoldWanted) await machine.Tool.OffAsync().ConfigureAwait(false);
            await GateAsync().ConfigureAwait(false);
            await machine.Tool.OnAsync(at).ConfigureAwait(false);
        }
        while (control.IsHoldWanted);
    }

    private async ValueTask AdjustAsync()
    {
        await machine.Speed.AdjustAsync().ConfigureAwait(false);
        log.ControlChanged(machine);
    }

    private async ValueTask HoldAsync()
    {
        Enter(JobPhase.Holding);
        var isProgram = machine.Phase.Program is not null;
        if (isProgram) await machine.Commands.SendAsync(ResidentServer.CloseGateCommand).ConfigureAwait(false);
        await machine.Speed.SendRatioAsync().ConfigureAwait(false);
        await AwaitStandstillAsync().ConfigureAwait(false);
        if (machine.Profile.Height is not null) throw await HeldMotion.GiveUpAsync(machine).ConfigureAwait(false);
        do
        {
            await machine.Tool.HoldOffAsync().ConfigureAwait(false);
            await StayAsync().ConfigureAwait(false);
            Enter(JobPhase.Resuming);
            await machine.Tool.HoldOnAsync(isCutting: machine.State.SequenceRunning && machine.Phase.WillMove(machine.State)).ConfigureAwait(false);
        }
        while (control.IsHoldWanted);
        await ReleaseAsync(isProgram).ConfigureAwait(false);
    }

    /// <summary>VR back; then polls until the path moves again, because a feeder takes a path at standstill for one that has run dry.</summary>
    private async ValueTask ReleaseAsync(bool isProgram)
    {
        await machine.Speed.SendRatioAsync().ConfigureAwait(false);
        if (isProgram && !machine.Phase.KeepsGate) await machine.Commands.SendAsync(ResidentServer.OpenGateCommand).ConfigureAwait(false);
        Enter(JobPhase.Running);
        var (from, willMove) = (machine.State.Time, machine.Phase.WillMove);
        await machine.PollUntilAsync(state => !state.SequenceRunning || state.PathSpeed != 0 || !willMove(state) || PollTimes.SamplesSince(from, state.Time) > SamplesToMove).ConfigureAwait(false);
    }

    /// <summary>Polls until two polls in a row see the machine at rest at the same position: at a corner where the path stops anyway, a single poll may
    /// see it at rest while VR still decreases.</summary>
    private async ValueTask AwaitStandstillAsync()
    {
        var from = machine.State.Time;
        CountsPoint? rest = null;
        while (true)
        {
            var isAtRest = await IsAtRestAsync().ConfigureAwait(false);
            if (isAtRest && rest == machine.State.Position) return;
            rest = isAtRest ? machine.State.Position : null;
            await machine.PollAsync().ConfigureAwait(false);
            var state = machine.State;
            if (!state.SequenceRunning) from = state.Time;
            if (PollTimes.SamplesSince(from, state.Time) > SamplesToBrake) throw JobEnd.Broken(Wording.Get("JobHold.DidNotStop", state.Position.X, state.Position.Y)).ToException();
            machine.Watch.HasProgress();
        }
    }

    /// <summary>The path is at standstill in the middle, or everything is at rest and nothing will begin.</summary>
    private async ValueTask<bool> IsAtRestAsync()
    {
        var state = machine.State;
        if (state.SequenceRunning) return state.PathSpeed == 0;
        if (state.AxesRunning) return false;
        if (machine.Phase.Program is not { } program || program.IsEnd(state.Calls)) return true;
        return await machine.Commands.TryAskAsync(ResidentProgram.Variables.AtGate).ConfigureAwait(false) is not 0.0;
    }

    /// <summary>Held until the operator resumes; watched and with heartbeats. A move by hand gives up what is held, and so does a spindle that is to stop: it
    /// has to turn again before anything continues.</summary>
    private async ValueTask StayAsync()
    {
        Holds++;
        Enter(JobPhase.Held);
        if (machine.Profile.Spindle is { StopsInHold: true }) throw await HeldMotion.GiveUpAsync(machine).ConfigureAwait(false);
        var at = machine.State.Position;
        while (control.IsHoldWanted)
        {
            await StandAsync(at).ConfigureAwait(false);
            if (control.Move is not null) throw await HeldMotion.GiveUpAsync(machine).ConfigureAwait(false);
        }
    }

    private async ValueTask StandAsync(CountsPoint at)
    {
        await machine.PollAsync().ConfigureAwait(false);
        if (machine.State.Position != at) throw JobEnd.Broken(Wording.Get("JobHold.Moved", at.X, at.Y, machine.State.Position.X, machine.State.Position.Y)).ToException();
        machine.Watch.HasProgress();
        await machine.RestAsync(double.PositiveInfinity).ConfigureAwait(false);
    }

    /// <summary>The job is held and nothing is in progress in the controller: the tool goes up, the spindle does as it is set to, and the operator may
    /// move the machine by hand. Returns when the job is to continue with the rest.</summary>
    public async ValueTask AwayAsync()
    {
        _isAttending = true;
        try
        {
            await machine.Tool.ClearAsync().ConfigureAwait(false);
            var stops = machine.Profile.Spindle is { StopsInHold: true };
            if (stops) await machine.Tool.StopInHoldAsync().ConfigureAwait(false);
            if (Phase != JobPhase.Held) Holds++;
            Enter(JobPhase.Held);
            var moves = new HeldMoves(machine, control, log, limits);
            while (control.IsHoldWanted)
            {
                if (control.Move is { } move) await moves.MakeAsync(move).ConfigureAwait(false);
                else await StandAsync(machine.State.Position).ConfigureAwait(false);
            }

            Enter(JobPhase.Resuming);
            _isReturning = true;
            if (stops) await machine.Tool.TurnAsync(on: true).ConfigureAwait(false);
            await machine.Speed.SendRatioAsync().ConfigureAwait(false);
        }
        finally
        {
            _isAttending = false;
        }
    }

    /// <summary>Something is about to be cut: after a hold the machine is back on its path.</summary>
    /// <returns>Whether it is the first cut after a hold that gave something up.</returns>
    public bool CutBegins()
    {
        if (!_isReturning) return false;
        _isReturning = false;
        if (Phase == JobPhase.Resuming) Enter(JobPhase.Running);
        return true;
    }

    private void Enter(JobPhase phase)
    {
        Phase = phase;
        control.Enter(phase);
        if (phase != JobPhase.Held && control.Move is not null) control.CompleteMove(JobResult.NotStarted(0, Wording.Get("JobHold.Resumed"))); // requested just before the resume, and not meant for the next hold
        log.ControlChanged(machine);
    }
}
