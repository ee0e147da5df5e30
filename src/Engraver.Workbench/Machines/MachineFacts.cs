using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Workbench.Machines.Arming;

namespace Engraver.Workbench.Machines;

/// <summary>Everything from which a status is made, in the controller's words. Immutable.</summary>
internal sealed record MachineFacts
{
    public static MachineFacts None { get; } = new();

    public string? Link { get; init; }

    public bool IsSimulation { get; init; }

    public MachineIdentity? Identity { get; init; }

    /// <summary>The last look; null before the first.</summary>
    public MachineReading? Poll { get; init; }

    /// <summary>A job has moved the machine since the last look.</summary>
    public bool PollIsOld { get; init; }

    /// <summary>Why the link is lost; null while it stands.</summary>
    public string? Lost { get; init; }

    public bool JobRuns { get; init; }

    public bool Stopping { get; init; }

    /// <summary>The last word of the job on this machine; a move by hand leaves it as it is.</summary>
    public JobProgress? Progress { get; init; }

    /// <summary>The last word of the job or the move by hand, whichever came last.</summary>
    public JobProgress? Told { get; init; }

    /// <summary>Controller counts at the drawing's zero, by the job that runs or ran last.</summary>
    public CountsPoint? Frame { get; init; }

    public string? LastRefusal { get; init; }

    /// <summary>How the last job on <see cref="LastLink"/> ended; null before the first.</summary>
    public JobOutcome? LastOutcome { get; init; }

    /// <summary>Where that was, also after the connection is gone.</summary>
    public string? LastLink { get; init; }

    /// <summary>What the last look says of now: nothing while a job runs, nothing once the link is lost.</summary>
    private MachineReading? Now => JobRuns || Lost is not null ? null : Poll;

    /// <summary>When the controller was heard last.</summary>
    public DateTimeOffset SeenAt { get; init; }

    public MachineStatus ToStatus(MachineProfile profile, ArmedJob? armed)
    {
        if (Link is null) return MachineStatus.Offline with { Time = SeenAt };
        var (state, reason) = StateOf(armed);
        var place = PlaceCounts();
        return new MachineStatus
        {
            State = state,
            Reason = reason,
            Link = Link,
            Controller = Identity?.Model,
            IsSimulation = IsSimulation,
            MachinePosition = place is { } at ? Millimetres(profile, at.X, at.Y) : null,
            WorkPosition = place is { } here && Frame is { } frame ? Millimetres(profile, (double)here.X - frame.X, (double)here.Y - frame.Y) : null,
            FollowingError = Now is not { } look ? null : Millimetres(profile, look.ErrorX, look.ErrorY) - default(Point2D),
            Speed = Now is { Moves: false } ? 0.0 : Now?.Speed / profile.Scale.Largest,
            Inputs = Now?.Inputs,
            Outputs = JobRuns ? Told?.Outputs : Now?.Outputs,
            ToolCommanded = JobRuns ? Told?.ToolOn : Now?.Outputs is { } outputs ? (outputs & (1 << (profile.ToolOutput - 1))) != 0 : null,
            MotorsOn = JobRuns ? true : Now is { } poll ? poll.MotorsOff.Length == 0 : null,
            MotorsOff = Now?.MotorsOff,
            Limit = Now?.Limit ?? "",
            LastRefusal = LastRefusal,
            LastOutcome = LastOutcome,
            Progress = Progress is { } told ? Engraved(profile, told) : null,
            ArmedUntil = state == MachineState.Armed ? armed?.Until : null,
            Time = SeenAt,
        };
    }

    private (MachineState State, string Reason) StateOf(ArmedJob? armed) => this switch
    {
        { JobRuns: true, Stopping: true } => (MachineState.Stopping, Wording.Get("MachineFacts.Braking")),
        { JobRuns: true } => (MachineState.Running, ""),
        { Lost: { } why } => (MachineState.Fault, why),
        { Poll: null } => (MachineState.Connected, ""),
        { Poll.AbortInput: true } => (MachineState.EmergencyStopOpen, Wording.Get("MachineFacts.AbortInputActive")),
        { Poll.Limit: { Length: > 0 } limit } => (MachineState.Fault, Wording.Get("MachineFacts.On", limit)),
        { Poll.LostPosition: { Length: > 0 } axes } => (MachineState.Fault, Wording.Get("MachineFacts.AxisSwitchedOffBecause", axes)),
        { Poll.Moves: true } => (MachineState.Busy, Wording.Get("MachineFacts.SomethingMovesNotOurs")),
        { Poll.ProgramRuns: true } => (MachineState.Busy, Wording.Get("MachineFacts.ProgramRunsControllerNot")),
        { Poll.MotorsOff: { Length: > 0 } axes } => (MachineState.MotorsOff, Wording.Get("MachineFacts.MotorOff", axes)),
        _ => armed is null ? (MachineState.Ready, "") : (MachineState.Armed, ""),
    };

    /// <summary>Controller's counts; the last that is known, also when the link is lost.</summary>
    private CountsPoint? PlaceCounts() => (JobRuns || PollIsOld) && Told is { } told
        ? new CountsPoint(told.X + (Frame?.X ?? 0), told.Y + (Frame?.Y ?? 0)) // without a frame only a move by hand tells, by the controller's zero
        : Poll is { } look ? new CountsPoint(look.X, look.Y) : null;

    private static EngravedProgress Engraved(MachineProfile profile, in JobProgress told) =>
        new(told.Stroke, told.SegmentsExecuted, told.SegmentCount, Millimetres(profile, told.X, told.Y), told.ToolOn, told.Seconds);

    private static Point2D Millimetres(MachineProfile profile, double x, double y) => profile.Scale.ToMillimetres(x, y);
}
