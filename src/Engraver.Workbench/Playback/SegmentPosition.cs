using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Workbench.Playback;

/// <summary>Finds positions inside one segment of a motion program, counts of the job frame.</summary>
internal static class SegmentPosition
{
    /// <summary>Angle before the start of a full circle at which a tool at its start may be reported, degrees.</summary>
    private const double NearStart = 1.0;

    /// <param name="from">Start of the segment.</param>
    /// <param name="fraction">Fraction of its length, 0 to 1.</param>
    public static Point2D At(in VectorSegment segment, CountsPoint from, double fraction)
    {
        if (segment.Kind == VectorSegmentKind.Line) return new Point2D(from.X + (fraction * ((double)segment.End.X - from.X)), from.Y + (fraction * ((double)segment.End.Y - from.Y)));
        var centre = new Point2D(from.X, from.Y) - Vector2D.FromPolar(segment.Radius, Angle.FromDegrees(segment.ThetaDegrees));
        return centre + Vector2D.FromPolar(segment.Radius, Angle.FromDegrees(segment.ThetaDegrees + (fraction * segment.DeltaDegrees)));
    }

    /// <summary>Fraction of a segment at its point nearest to a position, 0 to 1. Near the common start and end of a full circle it is 0.</summary>
    /// <param name="from">Start of the segment.</param>
    public static double FractionNear(in VectorSegment segment, CountsPoint from, Point2D place)
    {
        if (segment.Kind == VectorSegmentKind.Line)
        {
            var (x, y) = ((double)segment.End.X - from.X, (double)segment.End.Y - from.Y);
            var square = (x * x) + (y * y);
            return square > 0.0 ? Math.Clamp((((place.X - from.X) * x) + ((place.Y - from.Y) * y)) / square, 0.0, 1.0) : 0.0;
        }

        var centre = new Point2D(from.X, from.Y) - Vector2D.FromPolar(segment.Radius, Angle.FromDegrees(segment.ThetaDegrees));
        var sweep = Math.Abs(segment.DeltaDegrees);
        var turned = (((place - centre).Direction.Degrees - segment.ThetaDegrees) * Math.Sign(segment.DeltaDegrees)) % 360.0;
        if (turned < 0.0) turned += 360.0;
        var isBeforeStart = turned > Math.Min(180.0 + (sweep / 2.0), 360.0 - NearStart); // Nearer to the start than to the end, or within a degree of both.
        return isBeforeStart || sweep == 0.0 ? 0.0 : Math.Min(turned / sweep, 1.0);
    }

    /// <summary>A speed along the path (counts/s) as mm/s: with unequal axes it depends on the direction.</summary>
    public static double Millimetres(in VectorSegment segment, CountsPoint from, double done, double speed, CountsScale scale)
    {
        var way = SequenceKinematics.Direction(segment, from, segment.Length > 0.0 ? done / segment.Length : 0.0);
        return speed * scale.ToMillimetres(way).Length;
    }
}
