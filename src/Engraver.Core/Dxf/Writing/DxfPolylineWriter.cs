using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Writing;

/// <summary>Writes lines and arcs end to start as the vertices and bulges of an LWPOLYLINE.</summary>
public static class DxfPolylineWriter
{
    /// <summary>Degrees. A longer arc is not written as part of a polyline, because its bulge would not reproduce the circle exactly.</summary>
    private const double WidestSweep = 270.0;

    /// <summary>Degrees. Readers treat a shorter arc as a line.</summary>
    private const double FlattestSweep = 1e-5;

    /// <summary>Flags of a POLYLINE and of its vertices.</summary>
    private const int InSpace = 8;

    private const int VertexInSpace = 32;

    /// <summary>Flag of a polyline whose linetype pattern runs through its vertices.</summary>
    private const int RunsThrough = 128;

    /// <summary>Largest distance between joined ends, as a part of the coordinates and sizes.</summary>
    private const double Joint = 1e-11;

    /// <summary>True when the segments are lines and arcs, each beginning where the one before ends, so that a polyline reads back as the same
    /// segments.</summary>
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

    internal static void Write(DxfTagWriter tags, in DxfSheetEntity entity)
    {
        var (segments, closed) = (entity.Segments, entity.Closed);
        tags.Class("AcDbPolyline").Integer(90, segments.Count + (closed ? 0 : 1)).Integer(70, (closed ? 1 : 0) | (entity.RunsThrough ? RunsThrough : 0));
        if (entity.Width > 0.0) tags.Real(43, entity.Width);
        if (entity.Z.Start != 0.0) tags.Real(38, entity.Z.Start);
        foreach (var segment in segments)
        {
            Vertex(tags, segment.Start);
            if (segment.Kind == SegmentKind.Arc) tags.Real(42, Math.Tan(segment.Arc.Sweep.Radians / 4.0));
        }

        if (!closed) Vertex(tags, segments[^1].End);
    }

    /// <summary>A polyline of lines with a height for every vertex.</summary>
    internal static void WriteInSpace(DxfTagWriter tags, in DxfSheetEntity entity)
    {
        var (segments, heights, layer) = (entity.Segments, entity.Heights!, entity.Layer);
        tags.Class("AcDb3dPolyline").Integer(66, 1).Point(10, default(Point2D)).Integer(70, InSpace | (entity.Closed ? 1 : 0) | (entity.RunsThrough ? RunsThrough : 0));
        DxfWriter.InsertData(tags, entity);
        for (var i = 0; i < heights.Count; i++)
        {
            tags.Begin("VERTEX", DxfHandles.ModelSpace).Class("AcDbEntity").Text(8, layer).Class("AcDbVertex").Class("AcDb3dPolylineVertex");
            tags.Point(10, i < segments.Count ? segments[i].Start : segments[^1].End, heights[i]).Integer(70, VertexInSpace);
        }

        tags.Begin("SEQEND", DxfHandles.ModelSpace).Class("AcDbEntity").Text(8, layer);
    }

    private static void Vertex(DxfTagWriter tags, Point2D place) => tags.Real(10, place.X).Real(20, place.Y);

    private static bool Meet(in Segment before, in Segment after)
    {
        var size = 1.0 + Math.Abs(after.Start.X) + Math.Abs(after.Start.Y) + Radius(before) + Radius(after);
        return before.End == after.Start || before.End.DistanceTo(after.Start) <= Joint * size;
    }

    private static double Radius(in Segment segment) => segment.Kind == SegmentKind.Arc ? segment.Arc.Radius : 0.0;
}
