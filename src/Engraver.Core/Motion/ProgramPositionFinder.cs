using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>Finds places on a motion program.</summary>
public static class ProgramPositionFinder
{
    /// <summary>The counter may be older than the position by the time of one reply: short segments may have ended meanwhile.</summary>
    private const int SegmentsAhead = 12;

    /// <summary>Finds the place of a machine on a program.</summary>
    /// <param name="segments">Segments that were done when the position was read, or a few fewer.</param>
    /// <param name="at">Position, job frame.</param>
    /// <param name="tolerance">A position further from a segment than this is not on it, counts.</param>
    /// <returns>The first matching place from there on; the beginning of the segment where none matches, so that all parts are cut. Heights count where an axis
    /// is the tool drive.</returns>
    public static JobPosition Find(MotionProgram program, int segments, CountsPoint at, double tolerance)
    {
        ArgumentNullException.ThrowIfNull(program);
        for (var ahead = 0; ahead <= SegmentsAhead && program.SegmentAfter(segments + ahead) is var (start, segment, _); ahead++)
        {
            var (away, along) = program.Profile.Height is null || segment.Kind == VectorSegmentKind.Arc ? InPlan(start, segment, at, tolerance) : InSpace(start, segment.End, at);
            if (program.Profile.Height is not null && segment.Kind == VectorSegmentKind.Arc) away = double.Hypot(away, (double)at.Z - start.Z);
            if (away <= tolerance) return new JobPosition(segments + ahead, along);
        }

        return new JobPosition(segments, 0.0);
    }

    private static (double Away, double Along) InPlan(CountsPoint start, in VectorSegment segment, CountsPoint at, double tolerance)
    {
        var (course, place) = (new SegmentPath(start, segment), new Point2D(at.X, at.Y));
        return (course.DistanceTo(place), course.LengthTo(place, tolerance));
    }

    /// <summary>The distance from a line that may rise or fall, and along it.</summary>
    private static (double Away, double Along) InSpace(CountsPoint start, CountsPoint end, CountsPoint at)
    {
        var length = Length(start, end);
        if (length == 0.0) return (Length(start, at), 0.0);
        var along = 0.0;
        for (var axis = 0; axis < 3; axis++) along += ((double)at[axis] - start[axis]) * ((double)end[axis] - start[axis]) / length;
        along = Math.Clamp(along, 0.0, length);
        var away = 0.0;
        for (var axis = 0; axis < 3; axis++) away = double.Hypot(away, (double)at[axis] - start[axis] - (along * ((double)end[axis] - start[axis]) / length));
        return (away, along);
    }

    private static double Length(CountsPoint from, CountsPoint to) => double.Hypot(double.Hypot((double)to.X - from.X, (double)to.Y - from.Y), (double)to.Z - from.Z);
}
