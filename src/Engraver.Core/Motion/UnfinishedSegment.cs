using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>The segment that was in progress when a job ended: the controller counts whole segments only, but it has also reported its position.</summary>
public static class UnfinishedSegment
{
    /// <summary>The cut length of the segment, by the last position that was polled on it with the tool on.</summary>
    /// <param name="tolerance">A position further from the segment than this is not on it, counts.</param>
    /// <returns>Counts along the segment, never more than was cut; 0 when no such position is known or the whole job was cut.</returns>
    public static double CutLength(MotionProgram program, JobResult result, double tolerance)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(result);
        var cut = result.SegmentsExecuted - result.SegmentsUncut;
        var last = result.PolledTrace.LastOrDefault(point => point.ToolOn && point.Executed == cut);
        if (!last.ToolOn || program.SegmentAfter(cut) is not var (start, segment, _)) return 0.0;
        var (course, place) = (new SegmentPath(start, segment), new Point2D(last.Place.X, last.Place.Y));
        return course.DistanceTo(place) > tolerance ? 0.0 : course.LengthTo(place, tolerance);
    }
}
