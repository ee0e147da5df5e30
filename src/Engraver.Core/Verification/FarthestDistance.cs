using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Largest distance of a line or an arc from a drawn line or arc: exact where the nearest point to every point of it is within the ends of the drawn
/// segment, elsewhere an upper bound.</summary>
internal static class FarthestDistance
{
    /// <param name="drawn">A line, an arc or a circle.</param>
    /// <param name="part">A line, or an arc of at most half a turn.</param>
    public static double FromDrawn(in Segment drawn, in Segment part) => drawn.Kind == SegmentKind.Line ? FromLine(drawn.Line, part) : FromArc(drawn.Arc, part);

    private static double FromLine(LineSegment line, in Segment part)
    {
        var length = line.Length;
        if (length == 0.0) return RadialRange(line.Start, part).Max;
        var along = (line.End - line.Start) * (1.0 / length);
        var (least, most) = LinearRange(line.Start, along, part);
        var (right, left) = LinearRange(line.Start, new Vector2D(-along.Y, along.X), part);
        var beyond = Math.Max(0.0, Math.Max(-least, most - length));
        return double.Hypot(Math.Max(Math.Abs(right), Math.Abs(left)), beyond);
    }

    private static double FromArc(ArcSegment arc, in Segment part)
    {
        var (least, most) = RadialRange(arc.Centre, part);
        var beyond = arc.IsFullTurn ? 0.0 : AngleBeyond(arc, part, least);
        return Math.Max(Math.Abs(least - arc.Radius), Math.Abs(most - arc.Radius)) + (beyond * most);
    }

    /// <summary>Angle by which the part, seen from the centre of the arc, extends beyond the arc's sweep, radians; infinite when it cannot be determined
    /// simply.</summary>
    private static double AngleBeyond(ArcSegment arc, in Segment part, double nearest)
    {
        var sag = Sagitta(part);
        if (nearest <= 2.0 * sag || nearest <= 0.0) return double.PositiveInfinity;
        var bend = sag > 0.0 ? Math.Asin(sag / nearest) : 0.0;
        var (first, last) = (Ahead(arc, part.Start), Ahead(arc, part.End));
        if (Math.Abs(last - first) + (2.0 * bend) > Math.PI) return double.PositiveInfinity;
        var sweep = Math.Abs(arc.Sweep.Radians);
        var (low, high) = (Math.Min(first, last) - bend, Math.Max(first, last) + bend);
        if (low < 0.0 && high > sweep) return double.PositiveInfinity; // the part may pass on the other side of the circle
        return Math.Max(0.0, Math.Max(-low, high - sweep));
    }

    /// <summary>Angle of a point seen from the centre, from the arc's start in its direction; a little before the start is a little below 0.</summary>
    private static double Ahead(ArcSegment arc, Point2D place)
    {
        var sweep = arc.Sweep.Radians;
        var ahead = Math.IEEERemainder(((place - arc.Centre).Direction - arc.Start).Radians, 2.0 * Math.PI) * Math.Sign(sweep);
        if (ahead < 0.0) ahead += 2.0 * Math.PI;
        return ahead > Math.Abs(sweep) && (2.0 * Math.PI) - ahead < ahead - Math.Abs(sweep) ? ahead - (2.0 * Math.PI) : ahead;
    }

    private static double Sagitta(in Segment part) => part.Kind == SegmentKind.Line ? 0.0 : part.Arc.Radius * (1.0 - Math.Cos(Math.Abs(part.Arc.Sweep.Radians) / 2.0));

    /// <summary>Smallest and largest component of (place - origin) in a direction.</summary>
    public static (double Min, double Max) LinearRange(Point2D origin, Vector2D direction, in Segment part)
    {
        var (first, last) = ((part.Start - origin).Dot(direction), (part.End - origin).Dot(direction));
        var (min, max) = (Math.Min(first, last), Math.Max(first, last));
        if (part.Kind == SegmentKind.Line) return (min, max);
        var arc = part.Arc;
        var centre = (arc.Centre - origin).Dot(direction);
        if (arc.Covers(direction.Direction)) max = Math.Max(max, centre + (arc.Radius * direction.Length));
        if (arc.Covers((-direction).Direction)) min = Math.Min(min, centre - (arc.Radius * direction.Length));
        return (min, max);
    }

    /// <summary>Smallest and largest distance from a point.</summary>
    public static (double Min, double Max) RadialRange(Point2D centre, in Segment part)
    {
        var (first, last) = (part.Start.DistanceTo(centre), part.End.DistanceTo(centre));
        var (min, max) = (Math.Min(first, last), Math.Max(first, last));
        if (part.Kind == SegmentKind.Line) return (part.Line.DistanceTo(centre), max);
        var arc = part.Arc;
        var away = arc.Centre - centre;
        if (away == default) return (min, max);
        if (arc.Covers(away.Direction)) max = Math.Max(max, away.Length + arc.Radius);
        if (arc.Covers((-away).Direction)) min = Math.Min(min, Math.Abs(arc.Radius - away.Length));
        return (min, max);
    }
}
