using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines;

/// <summary>Snapshot of the machine's status. Immutable; null means unknown.</summary>
public sealed record MachineStatus
{
    public static MachineStatus Offline { get; } = new();

    public MachineState State { get; init; }

    /// <summary>The reason of the state if there is one (a limit switch, a lost link); empty otherwise.</summary>
    public string Reason { get; init; } = "";

    /// <summary>The address of the controller; null while none is connected.</summary>
    public string? Link { get; init; }

    /// <summary>The model reported by the controller.</summary>
    public string? Controller { get; init; }

    /// <summary>True for a simulated controller in this process.</summary>
    public bool IsSimulation { get; init; }

    /// <summary>The commanded position relative to the controller's zero (_RPA, _RPB), mm; the last known one after the link was lost, when all other values
    /// are null.</summary>
    public Point2D? MachinePosition { get; init; }

    /// <summary>Z position relative to the controller's zero, mm; null without a Z axis.</summary>
    public double? MachineHeight { get; init; }

    /// <summary>Tool height above the drawing's zero, mm; null if <see cref="WorkPosition"/> is, and without a Z axis.</summary>
    public double? WorkHeight { get; init; }

    /// <summary>Position in drawing millimetres, in the frame of the current or last job; null before the first.</summary>
    public Point2D? WorkPosition { get; init; }

    /// <summary>Following error (_TEA, _TEB), mm; known while no job runs.</summary>
    public Vector2D? FollowingError { get; init; }

    /// <summary>Speed along the path, mm/s; 0 at rest.</summary>
    public double? Speed { get; init; }

    /// <summary>Inputs 1 to 8, bit 0 is input 1 (_TI0).</summary>
    public int? Inputs { get; init; }

    /// <summary>Outputs 1 to 8, bit 0 is output 1 (_OP0).</summary>
    public int? Outputs { get; init; }

    /// <summary>Whether the tool output is on; the tool has no feedback.</summary>
    public bool? ToolCommanded { get; init; }

    /// <summary>Motors of all axes are on.</summary>
    public bool? MotorsOn { get; init; }

    /// <summary>The controller's letters of the axes whose motor is off; null when unknown.</summary>
    public string? MotorsOff { get; init; }

    /// <summary>The active limit, for example "forward limit of axis A"; empty if none.</summary>
    public string Limit { get; init; } = "";

    /// <summary>Number and text of the last refusal from this controller; null if there was none.</summary>
    public string? LastRefusal { get; init; }

    /// <summary>Outcome of the last job on this controller; null before the first.</summary>
    public JobOutcome? LastOutcome { get; init; }

    /// <summary>The last progress of the running job, or of an ended job that is still shown; null otherwise, so that the progress of another drawing is not
    /// shown.</summary>
    public EngravedProgress? Progress { get; init; }

    /// <summary>Feed override requested by the operator, a factor of the programmed feed.</summary>
    public double FeedRatio { get; init; } = 1.0;

    /// <summary>The feed override in force: lower than requested if arcs and corners of the running job limit it.</summary>
    public double FeedInForce { get; init; } = 1.0;

    /// <summary>Rapid override, a factor of the rapid speed.</summary>
    public double RapidRatio { get; init; } = 1.0;

    /// <summary>Time at which arming ends; null while not armed.</summary>
    public DateTimeOffset? ArmedUntil { get; init; }

    /// <summary>True if the tool stays off in the job that is armed, running or just ended.</summary>
    public bool IsDryRun { get; init; }

    /// <summary>Whether the machine was homed since power-on; null for a machine without homing.</summary>
    public bool? IsHomed { get; init; }

    /// <summary>A simulated machine that counts as homed without homing.</summary>
    public bool HomingIsAssumed { get; init; }

    /// <summary>True if the controller no longer answers; the other values are then the last known ones.</summary>
    public bool IsLinkLost { get; init; }

    /// <summary>Why the position of the drawing's zero is unknown, and what to do; null while it is known.</summary>
    public Diagnostic? OriginMissing { get; init; }

    /// <summary>Time of the last answer of the controller.</summary>
    public DateTimeOffset Time { get; init; }
}
