namespace Engraver.Core.Geometry;

/// <summary>Tests whether a segment touches a box, for a crossing selection.</summary>
public static class BoxTouch
{
    /// <summary>After this number of halvings a piece of a curve equals its chord within rounding.</summary>
    private const int MaxHalvings = 24;

    /// <summary>True when any point of the segment is in the box, its border included.</summary>
    public static bool Touches(this Bounds2D box, Segment segment)
    {
        if (box.IsEmpty) return false;
        if (box.Contains(segment.Start) || box.Contains(segment.End)) return true;
        if (segment.IsFreeCurve) return segment.Curve.Pieces().Any(piece => CurveCrosses(box, piece.Spans[0], MaxHalvings));
        return segment.Kind == SegmentKind.Line ? LineCrosses(box, segment.Line) : ArcCrosses(box, segment.Arc);
    }

    /// <summary>Halves every part that crosses a border; a span whose control points are all beyond one border is outside.</summary>
    private static bool CurveCrosses(Bounds2D box, BezierSpan span, int halvings)
    {
        if (box.Contains(span.Start) || box.Contains(span.End)) return true;
        var hull = Bounds2D.Empty;
        for (var i = 0; i <= span.Degree; i++) hull = hull.Including(span.Control(i));
        if (hull.MaxX < box.MinX || hull.MinX > box.MaxX || hull.MaxY < box.MinY || hull.MinY > box.MaxY) return false;
        if (halvings == 0) return LineCrosses(box, new LineSegment(span.Start, span.End));
        var (first, second) = span.Halves();
        return CurveCrosses(box, first, halvings - 1) || CurveCrosses(box, second, halvings - 1);
    }

    /// <summary>Clips the line at the four borders (Liang and Barsky); true when a part remains.</summary>
    private static bool LineCrosses(Bounds2D box, LineSegment line)
    {
        var along = line.End - line.Start;
        var (from, to) = (0.0, 1.0);
        return Clip(-along.X, line.Start.X - box.MinX, ref from, ref to)
            && Clip(along.X, box.MaxX - line.Start.X, ref from, ref to)
            && Clip(-along.Y, line.Start.Y - box.MinY, ref from, ref to)
            && Clip(along.Y, box.MaxY - line.Start.Y, ref from, ref to);
    }

    private static bool Clip(double outward, double room, ref double from, ref double to)
    {
        if (outward == 0.0) return room >= 0.0;
        var at = room / outward;
        if (outward < 0.0) from = Math.Max(from, at);
        else to = Math.Min(to, at);
        return from <= to;
    }

    /// <summary>With both ends outside, the arc meets the box only through its border.</summary>
    private static bool ArcCrosses(Bounds2D box, ArcSegment arc)
    {
        var (cx, cy) = (arc.Centre.X, arc.Centre.Y);
        return Meets(arc, box.MinX - cx, box.MinY - cy, box.MaxY - cy, vertical: true)
            || Meets(arc, box.MaxX - cx, box.MinY - cy, box.MaxY - cy, vertical: true)
            || Meets(arc, box.MinY - cy, box.MinX - cx, box.MaxX - cx, vertical: false)
            || Meets(arc, box.MaxY - cy, box.MinX - cx, box.MaxX - cx, vertical: false);
    }

    /// <summary>Whether the arc crosses one border; border and its range are relative to the arc's centre.</summary>
    private static bool Meets(ArcSegment arc, double border, double from, double to, bool vertical)
    {
        if (Math.Abs(border) > arc.Radius) return false;
        var half = Math.Sqrt((arc.Radius - border) * (arc.Radius + border));
        return Passes(-half) || Passes(half);

        bool Passes(double along) => along >= from && along <= to && arc.Covers(vertical ? Angle.Direction(border, along) : Angle.Direction(along, border));
    }
}
