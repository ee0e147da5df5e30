using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Machines;

/// <summary>The values from which a status is computed, in the controller's units. Immutable.</summary>
internal sealed record MachineFacts
{
    public static MachineFacts None { get; } = new();

    public string? Link { get; init; }

    public bool IsSimulation { get; init; }

    public MachineIdentity? Identity { get; init; }

    /// <summary>The last poll; null before the first.</summary>
    public MachineReading? Poll { get; init; }

    /// <summary>True if a job has moved the machine since the last poll.</summary>
    public bool IsPollStale { get; init; }

    /// <summary>Why the link is lost; null while connected.</summary>
    public string? LinkFailure { get; init; }

    public bool IsJobRunning { get; init; }

    public bool IsStopping { get; init; }

    public double FeedRatio { get; init; } = 1.0;

    public double RapidRatio { get; init; } = 1.0;

    /// <summary>Displayed name of the manual move in progress; null during a job and when idle.</summary>
    public string? MoveName { get; init; }

    /// <summary>True if the tool stays off in the current or last job.</summary>
    public bool IsDryRun { get; init; }

    /// <summary>The feed hold state of the running job.</summary>
    public FeedHoldPhase FeedHold { get; init; }

    /// <summary>Outcome of the job whose progress is shown; null while it runs and after it was dismissed
    /// (<see cref="MachineStatusModel.DismissJob"/>).</summary>
    public JobOutcome? Ended { get; init; }

    /// <summary>Why the position of the drawing's zero is unknown, and what to do; null while it is known.</summary>
    public Diagnostic? OriginMissing { get; init; }

    /// <summary>Whether the machine was homed since power-on; null for a machine without homing.</summary>
    public bool? IsHomed { get; init; }

    /// <summary>A simulated machine that counts as homed without homing.</summary>
    public bool HomingIsAssumed { get; init; }

    /// <summary>The last progress of the last job on this machine; manual moves do not change it.</summary>
    public JobProgress? Progress { get; init; }

    /// <summary>The last progress of a job or a manual move, whichever is newer.</summary>
    public JobProgress? LastProgress { get; init; }

    /// <summary>Controller counts at the drawing's zero, of the current or last job.</summary>
    public CountsPoint? Frame { get; init; }

    public string? LastRefusal { get; init; }

    /// <summary>Outcome of the last job on <see cref="LastLink"/>; null before the first.</summary>
    public JobOutcome? LastOutcome { get; init; }

    /// <summary>Address of the last link, kept after disconnecting.</summary>
    public string? LastLink { get; init; }

    /// <summary>The last poll if it is current; null while a job runs and after the link was lost.</summary>
    private MachineReading? Now => IsJobRunning || LinkFailure is not null ? null : Poll;

    /// <summary>Time of the last answer of the controller.</summary>
    public DateTimeOffset LastAnswerTime { get; init; }

    public MachineStatus ToStatus(MachineProfile profile, ArmedJob? armed)
    {
        if (Link is null) return MachineStatus.Offline with { FeedRatio = FeedRatio, FeedInForce = FeedRatio, RapidRatio = RapidRatio, Time = LastAnswerTime };
        var (state, reason) = StateOf(profile.Axes, armed);
        var place = PlaceCounts();
        return new MachineStatus
        {
            State = state,
            Reason = reason,
            Link = Link,
            Controller = Identity?.Model,
            IsSimulation = IsSimulation,
            MachinePosition = place is { } at ? Millimetres(profile, at) : null,
            WorkPosition = place is { } here && Frame is { } frame ? Millimetres(profile, here - frame) : null,
            MachineHeight = place is { } height && profile.Axes.Z is not null ? profile.Scale.ToMillimetres(height.Z) : null,
            WorkHeight = place is { } tool && Frame is { } zero && profile.Axes.Z is not null ? profile.Scale.ToMillimetres(tool.Z - zero.Z) : null,
            FollowingError = Now is not { } look ? null : Millimetres(profile, look.Error) - default(Point2D),
            Speed = Now is { IsMoving: false } ? 0.0 : Now?.Speed is { } speed ? profile.Scale.Finer.LengthOf(speed) : null,
            Inputs = Now?.Inputs,
            Outputs = IsJobRunning ? LastProgress?.Outputs : Now?.Outputs,
            ToolCommanded = IsJobRunning ? LastProgress?.ToolOn : IsToolOn(profile),
            MotorsOn = IsJobRunning ? true : Now is { } poll ? poll.MotorsOff.Length == 0 : null,
            MotorsOff = Now?.MotorsOff,
            Limit = Now?.Limit ?? "",
            LastRefusal = LastRefusal,
            LastOutcome = LastOutcome,
            Progress = Progress is { } told && state is not (MachineState.Ready or MachineState.Armed or MachineState.NoOrigin) ? Engraved(profile, told) : null,
            FeedRatio = FeedRatio,
            FeedInForce = IsJobRunning && MoveName is null && LastProgress is { } job ? Math.Min(FeedRatio, job.FeedRatio) : FeedRatio,
            RapidRatio = RapidRatio,
            ArmedUntil = state == MachineState.Armed ? armed?.Until : null,
            IsDryRun = state == MachineState.Armed ? armed!.DryRun : IsDryRun && (IsJobRunning || Ended is not null),
            IsHomed = IsHomed,
            HomingIsAssumed = HomingIsAssumed,
            IsLinkLost = LinkFailure is not null,
            OriginMissing = OriginMissing,
            Time = LastAnswerTime,
        };
    }

    private (MachineState State, string Reason) StateOf(MachineAxes axes, ArmedJob? armed) => IsJobRunning ? AtWork() : this switch
    {
        { LinkFailure: { } why } => (MachineState.Fault, why),
        { Poll: null } => (MachineState.Connected, ""),
        { Poll.AbortInput: true } => (MachineState.EmergencyStopOpen, Wording.Get("MachineFacts.AbortInputActive")),
        { Poll.Limit: { Length: > 0 } limit } => (MachineState.Fault, Wording.Get("MachineFacts.LimitSwitchActive", limit)),
        { Poll.LostPosition: { Length: > 0 } lost } => (MachineState.Fault, Wording.Get("MachineFacts.AxisOff", axes.NamesOf(lost))),
        { Poll.IsMoving: true } => (MachineState.Busy, Wording.Get("MachineFacts.OtherMotion")),
        { Poll.IsProgramRunning: true } => (MachineState.Busy, Wording.Get("MachineFacts.OtherProgram")),
        { Poll.MotorsOff: { Length: > 0 } off } => (MachineState.MotorsOff, Wording.Get("MachineFacts.MotorOff", axes.NamesOf(off))),
        { IsHomed: false } => (MachineState.NotHomed, Wording.Get("MachineFacts.NotHomed")),
        _ when armed is not null => (MachineState.Armed, armed.DryRun ? Wording.Get("MachineFacts.ToolStaysOff") : ""),
        { Ended: JobOutcome.Complete } => (MachineState.Complete, IsDryRun ? Wording.Get("MachineFacts.DryRunCutNothing") : ""),
        { Ended: JobOutcome.Deviated } => (MachineState.Deviated, Wording.Get("MachineFacts.Deviated")),
        { Ended: { } outcome } => (MachineState.Stopped, OutcomeText.DisplayText(outcome)),
        { OriginMissing: { } missing } => (MachineState.NoOrigin, SettingWording.AtCommandLine(missing).Message),
        _ => (MachineState.Ready, ""),
    };

    /// <summary>The state during a job or a move of this program, and whether the tool stays off.</summary>
    private (MachineState State, string Reason) AtWork()
    {
        var dry = IsDryRun && MoveName is null ? Wording.Get("MachineFacts.ToolStaysOff") : "";
        return this switch
        {
            { IsStopping: true } => (MachineState.Stopping, dry.Length > 0 ? Wording.Get("MachineFacts.BrakingDry") : Wording.Get("MachineFacts.Braking")),
            { FeedHold: FeedHoldPhase.Braking } => (MachineState.Holding, dry.Length > 0 ? Wording.Get("MachineFacts.BrakingDry") : Wording.Get("MachineFacts.Braking")),
            { FeedHold: FeedHoldPhase.Held } => (MachineState.Held, dry),
            { MoveName: { } move } => (MachineState.Moving, move),
            { IsDryRun: true } => (MachineState.DryRun, dry),
            _ => (MachineState.Running, ""),
        };
    }

    /// <summary>From the last poll: the tool output, or the tool height relative to the retract height; null if unknown.</summary>
    private bool? IsToolOn(MachineProfile profile) => profile.Height is null
        ? Now?.Outputs is { } outputs ? profile.Tool.IsOn(outputs) : null
        : Now is { } look && Frame is { } frame ? profile.IsLower(look.Position.Z - frame.Z, profile.RetractCounts) : null;

    /// <summary>Position in controller counts; the last known one if the link is lost.</summary>
    private CountsPoint? PlaceCounts() => (IsJobRunning || IsPollStale) && LastProgress is { } told
        ? told.Place + (Frame ?? default) // Without a frame only a manual move reports positions, relative to the controller's zero.
        : Poll?.Position;

    private static EngravedProgress Engraved(MachineProfile profile, in JobProgress told) =>
        new(told.Stroke, told.SegmentsExecuted, told.SegmentCount, Millimetres(profile, told.Place), told.ToolOn, told.Seconds) { IsOnPath = told.IsOnPath };

    private static Point2D Millimetres(MachineProfile profile, CountsPoint counts) => profile.Scale.ToMillimetres(counts.X, counts.Y);
}
