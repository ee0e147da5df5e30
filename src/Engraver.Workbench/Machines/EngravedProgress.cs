using Engraver.Core.Geometry;

namespace Engraver.Workbench.Machines;

/// <summary>How far a job has come, by the controller's own count: what lies before is engraved, what lies behind is still to do.</summary>
/// <param name="Stroke">Place in <see cref="Galil.Programs.MotionProgram.Strokes"/> of the stroke under way.</param>
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
