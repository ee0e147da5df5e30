using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets;

/// <summary>The area inside a closed chain of lines and arcs, exactly (Green's theorem).</summary>
public static class ChainArea
{
    /// <summary>Signed area, mm2, counter-clockwise positive; the polygon of the ends plus the cap of every arc. Sums relative to the first start, so that a
    /// drawing far from the origin loses no digits.</summary>
    public static double Of(IReadOnlyList<Segment> segments)
    {
        if (segments.Count == 0) return 0.0;
        var origin = segments[0].Start;
        var twice = 0.0;
        foreach (var segment in segments)
        {
            twice += (segment.Start - origin).Cross(segment.End - origin);
            if (segment.Kind != SegmentKind.Line) twice += Cap(segment.Arc);
        }

        return twice / 2.0;
    }

    /// <summary>Twice the area between an arc and its chord. A flat arc has one of sweep^3 / 6, which the difference of sweep and sine would lose.</summary>
    private static double Cap(in ArcSegment arc)
    {
        var sweep = arc.Sweep.Radians;
        var difference = Math.Abs(sweep) < 1e-2 ? sweep * sweep * sweep / 6.0 * (1.0 - (sweep * sweep / 20.0 * (1.0 - (sweep * sweep / 42.0)))) : sweep - arc.Sweep.Sin();
        return arc.Radius * arc.Radius * difference;
    }
}
