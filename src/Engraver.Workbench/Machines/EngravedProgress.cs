using Engraver.Core.Geometry;

namespace Engraver.Workbench.Machines;

/// <summary>The progress of a job by the controller's segment counter: earlier segments are engraved, later ones are not.</summary>
/// <param name="Stroke">Index of the current stroke in <see cref="Engraver.Core.Machines.MotionProgram.Strokes"/>.</param>
/// <param name="SegmentsDone">Number of completed segments of the whole motion program.</param>
/// <param name="SegmentCount">Total number of segments.</param>
/// <param name="Position">Drawing millimetres.</param>
/// <param name="ToolOn">State of the tool output reported by the controller.</param>
/// <param name="Seconds">Controller time since the start of the job.</param>
public sealed record EngravedProgress(int Stroke, int SegmentsDone, int SegmentCount, Point2D Position, bool ToolOn, double Seconds)
{
    /// <summary>The controller runs a vector sequence: the position is on the segment after the completed ones.</summary>
    public bool IsOnPath { get; init; }

    /// <summary>Completed fraction by segments, 0 to 1.</summary>
    public double Fraction => SegmentCount == 0 ? 0.0 : (double)SegmentsDone / SegmentCount;
}
