using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Workbench.Playback;

/// <summary>Finds places inside one segment of a motion program, counts of the job frame.</summary>
internal static class SegmentPlace
{
    /// <param name="from">Where the segment begins.</param>
    /// <param name="fraction">0 to 1 along it.</param>
    public static Point2D At(in VectorSegment segment, CountsPoint from, double fraction)
    {
        if (segment.Kind == VectorSegmentKind.Line) return new Point2D(from.X + (fraction * ((double)segment.End.X - from.X)), from.Y + (fraction * ((double)segment.End.Y - from.Y)));
        var centre = new Point2D(from.X, from.Y) - Vector2D.FromPolar(segment.Radius, Angle.FromDegrees(segment.ThetaDegrees));
        return centre + Vector2D.FromPolar(segment.Radius, Angle.FromDegrees(segment.ThetaDegrees + (fraction * segment.DeltaDegrees)));
    }

    /// <summary>A speed along the path (counts/s) as mm/s: with unequal axes it depends on the direction.</summary>
    public static double Millimetres(in VectorSegment segment, CountsPoint from, double done, double speed, CountsScale scale)
    {
        var way = Direction(segment, from, segment.Length > 0.0 ? done / segment.Length : 0.0);
        return speed * double.Hypot(way.X / scale.X, way.Y / scale.Y);
    }

    private static Vector2D Direction(in VectorSegment segment, CountsPoint from, double fraction)
    {
        if (segment.Kind != VectorSegmentKind.Line)
        {
            var spoke = Angle.FromDegrees(segment.ThetaDegrees + (fraction * segment.DeltaDegrees));
            return new Vector2D(-spoke.Sin(), spoke.Cos());
        }

        var way = new Vector2D((double)segment.End.X - from.X, (double)segment.End.Y - from.Y);
        return way.Length > 0.0 ? way * (1.0 / way.Length) : default;
    }
}
