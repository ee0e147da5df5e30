using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>One segment of a vector sequence as a course: converts a length along it to a point, and back. Lengths are counts.</summary>
/// <param name="start">Start point.</param>
public readonly struct SegmentPath(Point2D start, VectorSegment segment)
{
    public SegmentPath(CountsPoint start, in VectorSegment segment)
        : this(new Point2D(start.X, start.Y), segment)
    {
    }

    public double Length => segment.Length;

    private Point2D End => new(segment.End.X, segment.End.Y);

    /// <summary>The arc of the segment; it begins exactly at the start.</summary>
    private ArcSegment Arc
    {
        get
        {
            var theta = Angle.FromDegrees(segment.ThetaDegrees);
            return new ArcSegment(start - Vector2D.FromPolar(segment.Radius, theta), segment.Radius, theta, Angle.FromDegrees(segment.DeltaDegrees));
        }
    }

    /// <summary>The point at this length along the segment; both ends are included.</summary>
    public Point2D At(double along)
    {
        var part = Length <= 0.0 ? 0.0 : Math.Clamp(along / Length, 0.0, 1.0);
        if (segment.Kind == VectorSegmentKind.Line) return start + ((End - start) * part);
        return Arc.Centre + Vector2D.FromPolar(segment.Radius, Angle.FromDegrees(segment.ThetaDegrees + (part * segment.DeltaDegrees)));
    }

    public double DistanceTo(Point2D place) => segment.Kind == VectorSegmentKind.Line ? new LineSegment(start, End).DistanceTo(place) : Arc.DistanceTo(place);

    /// <summary>Length along the segment to its point nearest to a place.</summary>
    /// <param name="tolerance">A whole turn ends where it begins: a place this near to the start counts as length 0.</param>
    public double LengthTo(Point2D place, double tolerance)
    {
        if (segment.Kind == VectorSegmentKind.Line)
        {
            var way = End - start;
            var length = way.Length;
            return length == 0.0 ? 0.0 : Math.Clamp((((place.X - start.X) * way.X) + ((place.Y - start.Y) * way.Y)) / length, 0.0, length);
        }

        if (start.DistanceTo(place) <= tolerance) return 0.0;
        var towards = place - Arc.Centre;
        var turned = (Math.Atan2(towards.Y, towards.X) * (180.0 / Math.PI)) - segment.ThetaDegrees;
        var swept = Math.IEEERemainder((segment.DeltaDegrees < 0.0 ? -turned : turned) - 180.0, 360.0) + 180.0; // 0 to 360
        if (swept > Math.Abs(segment.DeltaDegrees)) swept = swept - Math.Abs(segment.DeltaDegrees) < 360.0 - swept ? Math.Abs(segment.DeltaDegrees) : 0.0; // beside an end
        return Math.Min(swept * (Math.PI / 180.0) * segment.Radius, segment.Length);
    }
}
