using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Writing;

/// <summary>Writes a directed segment as LINE, ARC, CIRCLE, ELLIPSE or SPLINE, a run of them as LWPOLYLINE, so that its direction can be read back from the
/// geometry alone.</summary>
/// <remarks>A DXF ARC always runs counter-clockwise in its own system. A clockwise one is therefore written under the extrusion 0,0,-1, whose system is the
/// drawing seen from behind: x and angles are mirrored (x' = -x, angle' = 180 - angle; DXF reference, "Arbitrary Axis Algorithm"). A whole turn is always a
/// CIRCLE, because other programs draw an ARC from 30 to 390 degrees as a point; its start angle is in its extended data, when it has some.</remarks>
internal static class DxfSegmentWriter
{
    /// <summary>Degrees. Readers treat a smaller sweep as zero, so such an arc is written as the line between its ends.</summary>
    private const double SmallestSweep = 1e-8;

    public static void Write(DxfTagWriter tags, in DxfSheetEntity entity)
    {
        var segment = entity.Segment;
        if (entity.Heights is not null) DxfPolylineWriter.WriteInSpace(Begin(tags, "POLYLINE", entity), entity);
        else if (entity.Run is not null) DxfPolylineWriter.Write(Begin(tags, "LWPOLYLINE", entity), entity);
        else if (segment.IsFreeCurve) DxfCurveWriter.Write(Begin(tags, DxfCurveWriter.IsEllipse(segment.Curve) ? "ELLIPSE" : "SPLINE", entity), segment.Curve);
        else if (segment.Kind == SegmentKind.Line || Math.Abs(segment.Arc.Sweep.Degrees) < SmallestSweep) Line(tags, entity);
        else Round(tags, segment.Arc, entity);
    }

    private static void Line(DxfTagWriter tags, in DxfSheetEntity entity) =>
        Begin(tags, "LINE", entity).Class("AcDbLine").Point(10, entity.Segment.Start, entity.Z.Start).Point(11, entity.Segment.End, entity.Z.End);

    private static void Round(DxfTagWriter tags, ArcSegment arc, in DxfSheetEntity entity)
    {
        var mirrored = arc.Sweep.Degrees < 0.0;
        var centre = mirrored ? new Point2D(-arc.Centre.X, arc.Centre.Y) : arc.Centre;
        var start = StartOf(arc);
        Begin(tags, arc.IsFullTurn ? "CIRCLE" : "ARC", entity).Class("AcDbCircle").Point(10, centre, mirrored ? -entity.Z.Start : entity.Z.Start).Real(40, arc.Radius);
        if (mirrored) tags.Real(210, 0.0).Real(220, 0.0).Real(230, -1.0);
        if (!arc.IsFullTurn) tags.Class("AcDbArc").Real(50, start.Degrees).Real(51, End(start, arc));
    }

    /// <summary>The start angle in the arc's own system.</summary>
    public static Angle StartOf(ArcSegment arc) => (arc.Sweep.Degrees < 0.0 ? Angle.FromDegrees(180.0) - arc.Start : arc.Start).Positive();

    /// <summary>The end angle within one turn of the start.</summary>
    private static double End(Angle start, ArcSegment arc)
    {
        var end = start.Degrees + Math.Abs(arc.Sweep.Degrees);
        return end <= 360.0 ? end : end - 360.0;
    }

    private static DxfTagWriter Begin(DxfTagWriter tags, string type, in DxfSheetEntity entity) => tags.BeginEntity(type, entity.Layer, entity.Colour, entity.Hidden, entity.Linetype, entity.LinetypeScale, entity.Lineweight);
}
