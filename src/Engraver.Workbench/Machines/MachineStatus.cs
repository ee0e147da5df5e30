using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines;

/// <summary>What is known of the machine at one moment. Immutable; null is what nobody knows.</summary>
public sealed record MachineStatus
{
    public static MachineStatus Offline { get; } = new();

    public MachineState State { get; init; }

    /// <summary>Why the state is what it is, where that needs a word (a limit switch, a lost link); empty otherwise.</summary>
    public string Reason { get; init; } = "";

    /// <summary>Where the controller is; null while none is connected.</summary>
    public string? Link { get; init; }

    /// <summary>The model as the controller names itself.</summary>
    public string? Controller { get; init; }

    /// <summary>True for a controller that lives in this process.</summary>
    public bool IsSimulation { get; init; }

    /// <summary>The commanded position by the controller's own zero (_RPA, _RPB), mm; the last that is known once the link is lost, when everything else is null.</summary>
    public Point2D? MachinePosition { get; init; }

    /// <summary>In the drawing's millimetres, by the frame of the job that runs or ran last; null before the first.</summary>
    public Point2D? WorkPosition { get; init; }

    /// <summary>How far the motors are from their command (_TEA, _TEB), mm; known while no job runs.</summary>
    public Vector2D? FollowingError { get; init; }

    /// <summary>Along the path, mm/s; 0 at rest.</summary>
    public double? Speed { get; init; }

    /// <summary>Inputs 1 to 8, bit 0 is input 1 (_TI0).</summary>
    public int? Inputs { get; init; }

    /// <summary>Outputs 1 to 8, bit 0 is output 1 (_OP0).</summary>
    public int? Outputs { get; init; }

    /// <summary>Whether the tool output is switched on; what the tool does is not wired back.</summary>
    public bool? ToolCommanded { get; init; }

    /// <summary>Motors of both axes are on.</summary>
    public bool? MotorsOn { get; init; }

    /// <summary>The controller's letters of the axes whose motor is off; null while nobody knows.</summary>
    public string? MotorsOff { get; init; }

    /// <summary>The limit that is hit, for example "forward limit of axis A"; empty when none is.</summary>
    public string Limit { get; init; } = "";

    /// <summary>Number and text of the last refusal that was heard from this controller; null when there was none.</summary>
    public string? LastRefusal { get; init; }

    /// <summary>How the last job on this controller ended; null before the first.</summary>
    public JobOutcome? LastOutcome { get; init; }

    /// <summary>The last word of the job that runs or ran last; null before the first.</summary>
    public EngravedProgress? Progress { get; init; }

    /// <summary>Until when START works; null while not armed.</summary>
    public DateTimeOffset? ArmedUntil { get; init; }

    /// <summary>When the controller said so last.</summary>
    public DateTimeOffset Time { get; init; }
}

/// <summary>How far a job has come, by the controller's own count: what lies before is engraved, what lies behind is still to do.</summary>
/// <param name="Stroke">Place in <see cref="Engraver.Core.Machines.MotionProgram.Strokes"/> of the stroke under way.</param>
/// <param name="SegmentsDone">Segments of the whole motion program that are done, in the order of cutting.</param>
/// <param name="SegmentCount">How many there are.</param>
/// <param name="Position">Drawing millimetres.</param>
/// <param name="ToolOn">The tool output, as the controller says.</param>
/// <param name="Seconds">Controller time since the job began.</param>
public sealed record EngravedProgress(int Stroke, int SegmentsDone, int SegmentCount, Point2D Position, bool ToolOn, double Seconds)
{
    /// <summary>0 to 1, by segments.</summary>
    public double Fraction => SegmentCount == 0 ? 0.0 : (double)SegmentsDone / SegmentCount;
}
