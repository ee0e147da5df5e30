using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf;

/// <summary>Writes lines and arcs end to start as the vertices and bulges of an LWPOLYLINE.</summary>
public static class DxfPolylineWriter
{
    /// <summary>Degrees. Beyond it the chord says too little about the circle, so such an arc is no part of a polyline that is to read back as it was.</summary>
    private const double WidestSweep = 270.0;

    /// <summary>Degrees; readers take a flatter bulge for a line.</summary>
    private const double FlattestSweep = 1e-5;

    /// <summary>How far ends may lie apart, as a part of the coordinates and sizes.</summary>
    private const double Joint = 1e-11;

    /// <summary>True when the segments are lines and arcs, each beginning where the one before ends, so that they read back as they are.</summary>
    public static bool CanWrite(IReadOnlyList<Segment> segments, bool closed)
    {
        ArgumentNullException.ThrowIfNull(segments);
        for (var i = 0; i < segments.Count; i++)
        {
            var segment = segments[i];
            if (segment.Kind is not (SegmentKind.Line or SegmentKind.Arc) || segment.Start == segment.End) return false;
            if (segment.Kind == SegmentKind.Arc && Math.Abs(segment.Arc.Sweep.Degrees) is > WidestSweep or < FlattestSweep) return false;
            if (i + 1 < segments.Count && !Meet(segment, segments[i + 1])) return false;
        }

        return segments.Count > 0 && (!closed || (segments.Count > 1 && Meet(segments[^1], segments[0])));
    }

    internal static void Write(DxfTagWriter tags, IReadOnlyList<Segment> segments, bool closed)
    {
        tags.Class("AcDbPolyline").Integer(90, segments.Count + (closed ? 0 : 1)).Integer(70, closed ? 1 : 0);
        foreach (var segment in segments)
        {
            Vertex(tags, segment.Start);
            if (segment.Kind == SegmentKind.Arc) tags.Real(42, Math.Tan(segment.Arc.Sweep.Radians / 4.0));
        }

        if (!closed) Vertex(tags, segments[^1].End);
    }

    private static void Vertex(DxfTagWriter tags, Point2D place) => tags.Real(10, place.X).Real(20, place.Y);

    private static bool Meet(in Segment before, in Segment after)
    {
        var size = 1.0 + Math.Abs(after.Start.X) + Math.Abs(after.Start.Y) + Radius(before) + Radius(after);
        return before.End == after.Start || before.End.DistanceTo(after.Start) <= Joint * size;
    }

    private static double Radius(in Segment segment) => segment.Kind == SegmentKind.Arc ? segment.Arc.Radius : 0.0;
}
