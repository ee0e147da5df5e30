using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>The segment that was under way when a job ended: the controller counts whole segments only, but it has also said where it was.</summary>
public static class UnfinishedSegment
{
    /// <summary>How far the segment was cut, by the last position that was polled on it with the tool on.</summary>
    /// <param name="tolerance">A position further from the segment than this is not on it, counts.</param>
    /// <returns>Counts along the segment, never more than was cut; 0 when no such position is known or the job was cut whole.</returns>
    public static double CutLength(MotionProgram program, JobResult result, double tolerance)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(result);
        var cut = result.SegmentsExecuted - result.SegmentsUncut;
        var last = result.PolledTrace.LastOrDefault(point => point.ToolOn && point.Executed == cut);
        if (!last.ToolOn || program.SegmentBehind(cut) is not var (start, segment, _)) return 0.0;
        var (from, place) = (new Point2D(start.X, start.Y), new Point2D(last.X, last.Y));
        return segment.Kind == VectorSegmentKind.Line ? AlongLine(from, segment, place, tolerance) : AlongArc(from, segment, place, tolerance);
    }

    private static double AlongLine(Point2D start, in VectorSegment segment, Point2D place, double tolerance)
    {
        var line = new LineSegment(start, new Point2D(segment.End.X, segment.End.Y));
        return line.DistanceTo(place) > tolerance ? 0.0 : Math.Min(start.DistanceTo(place), segment.Length);
    }

    /// <remarks>Where a whole turn begins it also ends: there nothing counts as cut.</remarks>
    private static double AlongArc(Point2D start, in VectorSegment segment, Point2D place, double tolerance)
    {
        var radial = Vector2D.FromPolar(segment.Radius, Angle.FromDegrees(segment.ThetaDegrees));
        var arc = new ArcSegment(start - radial, segment.Radius, Angle.FromDegrees(segment.ThetaDegrees), Angle.FromDegrees(segment.DeltaDegrees));
        if (arc.DistanceTo(place) > tolerance || start.DistanceTo(place) <= tolerance) return 0.0;
        var towards = place - arc.Centre;
        var turned = (Math.Atan2(towards.Y, towards.X) * (180.0 / Math.PI)) - segment.ThetaDegrees;
        var swept = Math.IEEERemainder((segment.DeltaDegrees < 0.0 ? -turned : turned) - 180.0, 360.0) + 180.0; // 0 to 360
        return Math.Min(swept * (Math.PI / 180.0) * segment.Radius, segment.Length);
    }
}
