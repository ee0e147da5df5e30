using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Resident;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>What a job does about its <see cref="JobControl"/>: holds on the path and goes on, and puts overrides in force. It is asked after every poll,
/// so that every wait of every execution strategy can be held.</summary>
/// <remarks>
/// A running sequence is held by VR 0 (galil-dmc.md B.8): its segments stay in the buffer, the polls, the heartbeat and the watchdog go on. The tool goes
/// off once the path stands. VR does not reach a rapid, which
/// is finished; what comes behind it waits at a gate: of this computer before a rapid, a tool or a call, or, where a program runs the job, of that program
/// behind its rapid.
/// Where an axis holds the tool, and where the operator moves the machine by hand, what is held is given up (<see cref="JobStep.Parted"/>): its axes are
/// free then. The job stays held in <see cref="AwayAsync"/> and cuts the rest anew.
/// </remarks>
internal sealed class JobHold(JobMachine machine, JobControl control, IReadOnlyList<SoftLimit> limits)
{
    /// <summary>After VR is back the path moves within this many samples, or it does not move at all.</summary>
    private const int SamplesToMove = 50;

    /// <summary>Polls in which a sequence that was given up may still be reported as running before AB 1 ends it.</summary>
    private const int PatiencePolls = 50;

    private double _rapidRatio = 1.0;
    private bool _isAttending;
    private bool _isOnTheWayBack;

    public SpeedRatio Speed { get; } = new(control);

    /// <summary>Told when the phase changes or an override comes in force.</summary>
    public Action? Changed { get; set; }

    /// <summary>Told when what was under way is given up, before anything of it ends in the controller: from here on the watchdog's variables tell nothing
    /// of this job.</summary>
    public Action? Parted { get; set; }

    /// <summary>A program in the controller runs the job: whether it has come to its end. Null while this computer commands every motion.</summary>
    public Func<MachineState, bool>? HasProgramEnded { get; set; }

    /// <summary>The program waits at its gate for something else than the hold, and whoever made it wait lets it go on.</summary>
    public bool KeepsGate { private get; set; }

    /// <summary>Whether the sequence that stands still will move again; it will not where it has run dry.</summary>
    public Func<MachineState, bool> WillMove { get; set; } = _ => true;

    /// <summary>What the job does about a hold.</summary>
    public JobPhase Phase { get; private set; }

    /// <summary>Waits until the program in the controller can be called again; null where none is called.</summary>
    public Func<ValueTask<JobStep>>? AwaitIdle { get; set; }

    /// <summary>VR as it was sent last.</summary>
    public double Ratio { get; private set; } = 1.0;

    /// <summary>The rapid override.</summary>
    public double RapidRatio => control.RapidRatio;

    /// <summary>How often the machine stood held.</summary>
    public int Holds { get; private set; }

    /// <summary>The operator wants something that is not in force yet.</summary>
    public bool IsAsked => !_isAttending && (Speed.Wanted != Ratio || control.RapidRatio != _rapidRatio);

    /// <summary>A path that still runs this long after VR 0 does not obey it: twice the longest ramp, and two seconds.</summary>
    private double SamplesToBrake => 1000.0 * (2.0 + (2.0 * JobControl.FeedRange.Fastest * machine.Profile.VectorSpeed() / machine.Profile.AccelerationCounts));

    /// <summary>SP of one axis under the rapid override.</summary>
    public int RapidSpeed(MachineAxis axis) => Math.Max(DmcLimits.SlowestSpeed, 2 * (int)(machine.Profile.RapidSpeed(axis) * control.RapidRatio / 2.0));

    /// <summary>A program was started that has set SP by itself.</summary>
    public void RapidsAreAsPlanned() => _rapidRatio = 1.0;

    /// <summary>Call after every poll: holds, or puts an override in force.</summary>
    public async ValueTask<JobStep> AttendAsync()
    {
        if (!IsAsked || machine.IsStopped) return JobStep.Done;
        _isAttending = true;
        try
        {
            var state = machine.State;
            if (control.IsHoldWanted && (state.SequenceRunning || HasProgramEnded is not null)) return await HoldAsync().ConfigureAwait(false);
            return control.IsHoldWanted ? JobStep.Done : await AdjustAsync().ConfigureAwait(false);
        }
        finally
        {
            _isAttending = false;
        }
    }

    /// <summary>Call where the machine stands with the tool off and something is about to begin: waits while the job is held.</summary>
    public async ValueTask<JobStep> GateAsync()
    {
        if (!control.IsHoldWanted || _isAttending) return JobStep.Done;
        _isAttending = true;
        try
        {
            if (await StayAsync().ConfigureAwait(false) is { Ends: true } end) return end;
            Enter(JobPhase.Running);
            return JobStep.Done; // whoever waited here sends what comes next with the ratio that is wanted then
        }
        finally
        {
            _isAttending = false;
        }
    }

    /// <summary>Tool on where the next motion begins at once; a hold meanwhile switches it off again and is waited for.</summary>
    /// <param name="at">Where the motion begins, job frame.</param>
    public async ValueTask<JobStep> ToolOnAsync(CountsPoint at)
    {
        do
        {
            if (control.IsHoldWanted && await machine.Tool.OffAsync().ConfigureAwait(false) is { Ends: true } on) return on;
            if (await GateAsync().ConfigureAwait(false) is { Ends: true } held) return held;
            if (await machine.Tool.OnAsync(at).ConfigureAwait(false) is { Ends: true } end) return end;
        }
        while (control.IsHoldWanted);
        return JobStep.Done;
    }

    /// <summary>Sends the ratio that is wanted now, whatever was sent before, and reads it back.</summary>
    public async ValueTask<JobStep> SendRatioAsync()
    {
        var ratio = Speed.Wanted;
        if (await machine.SendAsync(SpeedRatio.Command(ratio)).ConfigureAwait(false) is { Ends: true } refused) return refused;
        Ratio = ratio;
        return await SettingCheck.ReadBackAsync(machine, ("_VRS", ratio, SettingCheck.Exact)).ConfigureAwait(false);
    }

    private async ValueTask<JobStep> AdjustAsync()
    {
        if (Speed.Wanted != Ratio && await SendRatioAsync().ConfigureAwait(false) is { Ends: true } end) return end;

        // SP acts in motion too. A program sets it in its first lines, before its first motion: only behind those it stays as it is sent here.
        var isSettingUp = HasProgramEnded is not null && !machine.State.AxesRunning && machine.State.Calls == 0;
        if (control.RapidRatio != _rapidRatio && !isSettingUp && await SendRapidsAsync().ConfigureAwait(false) is { Ends: true } broken) return broken;
        Changed?.Invoke();
        return JobStep.Done;
    }

    /// <summary>In plan only: SP acts in motion too, and the tool's axis may be plunging.</summary>
    private ValueTask<JobStep> SendRapidsAsync()
    {
        _rapidRatio = control.RapidRatio;
        return machine.SendAllAsync(new[] { machine.Profile.Axes.X, machine.Profile.Axes.Y }.Select(axis => Text($"SP{axis.Letter}={RapidSpeed(axis)}")));
    }

    private async ValueTask<JobStep> HoldAsync()
    {
        Enter(JobPhase.Holding);
        var isProgram = HasProgramEnded is not null;
        if (isProgram && await machine.SendAsync(ResidentServer.CloseGateCommand).ConfigureAwait(false) is { Ends: true } open) return open;
        if (await SendRatioAsync().ConfigureAwait(false) is { Ends: true } unsent) return unsent;
        if (await AwaitStandstillAsync().ConfigureAwait(false) is { Ends: true } moving) return moving;
        if (machine.Profile.Height is not null) return await PartAsync().ConfigureAwait(false);
        do
        {
            if (await machine.Tool.HoldOffAsync().ConfigureAwait(false) is { Ends: true } on) return on;
            if (await StayAsync().ConfigureAwait(false) is { Ends: true } end) return end;
            Enter(JobPhase.Resuming);
            var isCutting = machine.State.SequenceRunning && WillMove(machine.State);
            if (await machine.Tool.HoldOnAsync(isCutting).ConfigureAwait(false) is { Ends: true } off) return off;
        }
        while (control.IsHoldWanted);
        return await GoOnAsync(isProgram).ConfigureAwait(false);
    }

    /// <summary>VR back; then polls until the path moves again, because a path that stands has run dry for those who feed it.</summary>
    private async ValueTask<JobStep> GoOnAsync(bool isProgram)
    {
        if (await SendRatioAsync().ConfigureAwait(false) is { Ends: true } unsent) return unsent;
        if (isProgram && !KeepsGate && await machine.SendAsync(ResidentServer.OpenGateCommand).ConfigureAwait(false) is { Ends: true } closed) return closed;
        Enter(JobPhase.Running);
        var from = machine.State.Time;
        return await machine.PollUntilAsync(state => !state.SequenceRunning || state.PathSpeed != 0 || !WillMove(state) || PollTimes.SamplesSince(from, state.Time) > SamplesToMove).ConfigureAwait(false);
    }

    /// <summary>Polls until two looks in a row see the machine at rest at the same place: at a corner where the path stops by itself one look may, while VR
    /// still runs down.</summary>
    private async ValueTask<JobStep> AwaitStandstillAsync()
    {
        var from = machine.State.Time;
        CountsPoint? rest = null;
        while (true)
        {
            var isAtRest = await IsAtRestAsync().ConfigureAwait(false);
            if (isAtRest && rest == machine.State.Position) return JobStep.Done;
            rest = isAtRest ? machine.State.Position : null;
            if (await machine.PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
            var state = machine.State;
            if (!state.SequenceRunning) from = state.Time;
            if (PollTimes.SamplesSince(from, state.Time) > SamplesToBrake) return JobStep.Broken(Wording.Get("JobHold.DidNotStop", state.Position.X, state.Position.Y));
            machine.HasProgress();
        }
    }

    /// <summary>The path stands in the middle, or everything stands where nothing is begun by itself.</summary>
    private async ValueTask<bool> IsAtRestAsync()
    {
        var state = machine.State;
        if (state.SequenceRunning) return state.PathSpeed == 0;
        if (state.AxesRunning) return false;
        if (HasProgramEnded is not { } hasEnded || hasEnded(state)) return true;
        var (atGate, end) = await machine.AskAsync(ResidentProgram.Variables.AtGate).ConfigureAwait(false);
        return end.Ends || atGate != 0;
    }

    /// <summary>Stands held until the operator wants it otherwise; watched and with heartbeats. A move by hand gives up what is held, and so does a spindle
    /// that is to stop: it has to turn again before anything goes on.</summary>
    private async ValueTask<JobStep> StayAsync()
    {
        Holds++;
        Enter(JobPhase.Held);
        if (machine.Profile.Spindle is { StopsInHold: true }) return await PartAsync().ConfigureAwait(false);
        var at = machine.State.Position;
        while (control.IsHoldWanted)
        {
            if (await StandAsync(at).ConfigureAwait(false) is { Ends: true } end) return end;
            if (control.Move is not null) return await PartAsync().ConfigureAwait(false);
        }

        return JobStep.Done;
    }

    private async ValueTask<JobStep> StandAsync(CountsPoint at)
    {
        if (await machine.PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        if (machine.State.Position != at) return JobStep.Broken(Wording.Get("JobHold.Moved", at.X, at.Y, machine.State.Position.X, machine.State.Position.Y));
        machine.HasProgress();
        await machine.RestAsync(double.PositiveInfinity).ConfigureAwait(false);
        return JobStep.Done;
    }

    /// <summary>Gives up what is held, at its standstill. A program that runs the job is halted first, because it would go on with its next line when the
    /// sequence ends; STS then ends that (galil-dmc.md B.8), and AB 1 where STS does not end what VR 0 holds.</summary>
    /// <returns><see cref="JobStep.Parted"/>, or why it could not be done.</returns>
    private async ValueTask<JobStep> PartAsync()
    {
        var isInside = machine.State.SequenceRunning;
        if (!isInside && AwaitIdle is { } idle && await idle().ConfigureAwait(false) is { Ends: true } busy) return busy;
        if (await machine.PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        machine.Part(isInside);
        machine.Tool.Part();
        Parted?.Invoke();

        // First the mark: a server counts a call whose sequence is ended here, and a watchdog that tripped behind it would tell of a cut that was not made.
        if (await machine.SendAsync(ResidentServer.MarkCommand(-machine.Mark)).ConfigureAwait(false) is { Ends: true } unmarked) return unmarked;
        if (HasProgramEnded is not null && await machine.SendAsync(ResidentServer.IdleCommand).ConfigureAwait(false) is { Ends: true } runs) return runs;
        if (isInside && await EndSequenceAsync().ConfigureAwait(false) is { Ends: true } open) return open;
        return await machine.SendAsync("CSS").ConfigureAwait(false) is { Ends: true } full ? full : JobStep.Parted;
    }

    private async ValueTask<JobStep> EndSequenceAsync()
    {
        if (await machine.SendAsync("STS").ConfigureAwait(false) is { Ends: true } refused) return refused;
        for (var polls = 0; machine.State.SequenceRunning; polls++)
        {
            if (polls == PatiencePolls && await machine.SendAsync("AB 1").ConfigureAwait(false) is { Ends: true } unended) return unended;
            if (await machine.PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
            if (polls > PatiencePolls) await machine.RestAsync(double.PositiveInfinity).ConfigureAwait(false);
        }

        return AwaitIdle is { } idle ? await idle().ConfigureAwait(false) : JobStep.Done;
    }

    /// <summary>The job stands held and nothing is under way in the controller: the tool goes up, the spindle does as it is set to, and the operator may
    /// move the machine by hand. Returns when the job is to go on with what is left.</summary>
    public async ValueTask<JobStep> AwayAsync()
    {
        _isAttending = true;
        try
        {
            if (await machine.Tool.ClearAsync().ConfigureAwait(false) is { Ends: true } down) return down;
            var stops = machine.Profile.Spindle is { StopsInHold: true };
            if (stops && await machine.Tool.TurnAsync(on: false).ConfigureAwait(false) is { Ends: true } turning) return turning;
            if (Phase != JobPhase.Held) Holds++;
            Enter(JobPhase.Held);
            while (control.IsHoldWanted)
            {
                var step = control.Move is { } move ? await new HeldMoves(machine, control, limits, () => Changed?.Invoke()).MakeAsync(move).ConfigureAwait(false) : await StandAsync(machine.State.Position).ConfigureAwait(false);
                if (step.Ends) return step;
            }

            Enter(JobPhase.Resuming);
            _isOnTheWayBack = true;
            if (stops && await machine.Tool.TurnAsync(on: true).ConfigureAwait(false) is { Ends: true } standing) return standing;
            return await SendRatioAsync().ConfigureAwait(false);
        }
        finally
        {
            _isAttending = false;
        }
    }

    /// <summary>Something is about to be cut: behind a hold the machine is back on its path.</summary>
    /// <returns>Whether it is the first thing that is cut behind a hold that gave something up.</returns>
    public bool CutBegins()
    {
        if (!_isOnTheWayBack) return false;
        _isOnTheWayBack = false;
        if (Phase == JobPhase.Resuming) Enter(JobPhase.Running);
        return true;
    }

    private void Enter(JobPhase phase)
    {
        Phase = phase;
        control.Enter(phase);
        if (phase != JobPhase.Held && control.Move is not null) control.MoveEnds(JobResult.NotStarted(0, Wording.Get("JobHold.Resumed"))); // asked for just before the resume; at the next hold nobody means it
        Changed?.Invoke();
    }
}
