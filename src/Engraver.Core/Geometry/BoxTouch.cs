namespace Engraver.Core.Geometry;

/// <summary>Whether a segment touches a box: what a crossing selection asks.</summary>
public static class BoxTouch
{
    /// <summary>True when any point of the segment lies in the box, its border included.</summary>
    public static bool Touches(this Bounds2D box, Segment segment)
    {
        if (box.IsEmpty) return false;
        if (box.Contains(segment.Start) || box.Contains(segment.End)) return true;
        return segment.Kind == SegmentKind.Line ? LineCrosses(box, segment.Line) : ArcCrosses(box, segment.Arc);
    }

    /// <summary>Liang and Barsky's clipping: is anything of the line left between the four borders?</summary>
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

    /// <summary>Does the arc pass one border? Everything relative to its centre.</summary>
    private static bool Meets(ArcSegment arc, double border, double from, double to, bool vertical)
    {
        if (Math.Abs(border) > arc.Radius) return false;
        var half = Math.Sqrt((arc.Radius - border) * (arc.Radius + border));
        return Passes(-half) || Passes(half);

        bool Passes(double along) => along >= from && along <= to && arc.Covers(vertical ? Angle.Direction(border, along) : Angle.Direction(along, border));
    }
}
