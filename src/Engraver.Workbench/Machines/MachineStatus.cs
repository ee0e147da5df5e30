using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines;

/// <summary>What is known of the machine at one moment. Immutable; null is unknown.</summary>
public sealed record MachineStatus
{
    public static MachineStatus Offline { get; } = new();

    public MachineState State { get; init; }

    /// <summary>The reason of the state where it has one (a limit switch, a lost link); empty otherwise.</summary>
    public string Reason { get; init; } = "";

    /// <summary>The address of the controller; null while none is connected.</summary>
    public string? Link { get; init; }

    /// <summary>The model as the controller names itself.</summary>
    public string? Controller { get; init; }

    /// <summary>True for a controller that lives in this process.</summary>
    public bool IsSimulation { get; init; }

    /// <summary>The commanded position by the controller's own zero (_RPA, _RPB), mm; the last that is known once the link is lost, when everything else is
    /// null.</summary>
    public Point2D? MachinePosition { get; init; }

    /// <summary>Of the Z axis by the controller's own zero, mm; null on a machine without one.</summary>
    public double? MachineHeight { get; init; }

    /// <summary>The tool's height over the drawing's zero, mm; null where <see cref="WorkPosition"/> is, and on a machine without a Z axis.</summary>
    public double? WorkHeight { get; init; }

    /// <summary>Position in drawing millimetres, by the frame of the job that runs or ran last; null before the first.</summary>
    public Point2D? WorkPosition { get; init; }

    /// <summary>How far the motors are from their command (_TEA, _TEB), mm; known while no job runs.</summary>
    public Vector2D? FollowingError { get; init; }

    /// <summary>Speed along the path, mm/s; 0 at rest.</summary>
    public double? Speed { get; init; }

    /// <summary>Inputs 1 to 8, bit 0 is input 1 (_TI0).</summary>
    public int? Inputs { get; init; }

    /// <summary>Outputs 1 to 8, bit 0 is output 1 (_OP0).</summary>
    public int? Outputs { get; init; }

    /// <summary>Whether the tool output is switched on; what the tool does is not wired back.</summary>
    public bool? ToolCommanded { get; init; }

    /// <summary>Motors of all axes are on.</summary>
    public bool? MotorsOn { get; init; }

    /// <summary>The controller's letters of the axes whose motor is off; null when unknown.</summary>
    public string? MotorsOff { get; init; }

    /// <summary>The limit that is hit, for example "forward limit of axis A"; empty when none is.</summary>
    public string Limit { get; init; } = "";

    /// <summary>Number and text of the last refusal that was heard from this controller; null when there was none.</summary>
    public string? LastRefusal { get; init; }

    /// <summary>How the last job on this controller ended; null before the first.</summary>
    public JobOutcome? LastOutcome { get; init; }

    /// <summary>The last progress of the job that runs, or that has ended and is still shown; null otherwise, so never that of another drawing.</summary>
    public EngravedProgress? Progress { get; init; }

    /// <summary>Factor of the programmed feed that the operator asked for.</summary>
    public double FeedRatio { get; init; } = 1.0;

    /// <summary>The factor that is in force: less than asked for where arcs and bends of the job under way do not bear it.</summary>
    public double FeedInForce { get; init; } = 1.0;

    /// <summary>Factor of the rapid speed.</summary>
    public double RapidRatio { get; init; } = 1.0;

    /// <summary>Time at which arming ends; null while not armed.</summary>
    public DateTimeOffset? ArmedUntil { get; init; }

    /// <summary>True when the tool stays off in the job that is armed, runs or has just ended.</summary>
    public bool IsDryRun { get; init; }

    /// <summary>Whether the machine was homed since power-on; null for one that is not homed at all.</summary>
    public bool? IsHomed { get; init; }

    /// <summary>It is simulated, and counts as homed though nobody homed it.</summary>
    public bool HomingIsAssumed { get; init; }

    /// <summary>True when the controller answers no more; the other values are then the last known ones.</summary>
    public bool IsLinkLost { get; init; }

    /// <summary>Why the place of the drawing's zero is unknown, and what to do; null while it is known.</summary>
    public Diagnostic? OriginMissing { get; init; }

    /// <summary>Time of the last answer of the controller.</summary>
    public DateTimeOffset Time { get; init; }
}

/// <summary>The progress of a job by the controller's own count of segments: earlier ones are engraved, later ones are still to do.</summary>
/// <param name="Stroke">Place in <see cref="Engraver.Core.Machines.MotionProgram.Strokes"/> of the stroke under way.</param>
/// <param name="SegmentsDone">Segments of the whole motion program that are done, in the order of cutting.</param>
/// <param name="SegmentCount">How many there are.</param>
/// <param name="Position">Drawing millimetres.</param>
/// <param name="ToolOn">The tool output, as the controller says.</param>
/// <param name="Seconds">Controller time since the job began.</param>
public sealed record EngravedProgress(int Stroke, int SegmentsDone, int SegmentCount, Point2D Position, bool ToolOn, double Seconds)
{
    /// <summary>The controller runs a vector sequence: the place is on the segment after those that are done.</summary>
    public bool IsOnPath { get; init; }

    /// <summary>From 0 to 1, by segments.</summary>
    public double Fraction => SegmentCount == 0 ? 0.0 : (double)SegmentsDone / SegmentCount;
}
