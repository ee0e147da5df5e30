using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Constructions;

namespace Engraver.Workbench.Objects;

/// <summary>Computes the parts of objects after dragging their grips. Drawing units; heights are unchanged.</summary>
public static class GripStretch
{
    /// <summary>Below this bulge a side is straight.</summary>
    private const double MinBulge = 1e-8;

    /// <summary>The changed parts; null if something would vanish: a line without length, an arc without radius.</summary>
    /// <param name="drawing">The drawing.</param>
    /// <param name="hot">Grips at one point.</param>
    /// <param name="to">The new position.</param>
    public static IReadOnlyList<ChangedPart>? Changes(Drawing drawing, IReadOnlyList<Grip> hot, Point2D to)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(hot);
        var changes = hot.GroupBy(grip => grip.Entity).SelectMany(grips => OfEntity(drawing, [.. grips], to)).ToList();
        return changes.TrueForAll(change => change.IsSound) ? changes : null;
    }

    private static IEnumerable<ChangedPart> OfEntity(Drawing drawing, IReadOnlyList<Grip> grips, Point2D to)
    {
        var entity = drawing.Entities[grips[0].Entity];
        var parts = Enumerable.Range(entity.FirstPart, entity.PartCount);
        var (place, whole) = (grips[0].Place, grips.Any(grip => grip.Kind == GripKind.Whole));
        if (whole) return parts.Select(part => ChangedPart.Moved(drawing, part, to - place));
        if (grips.FirstOrDefault(grip => grip.Kind is GripKind.Bulge or GripKind.Radius or GripKind.Axis) is { Part: var own, Kind: not GripKind.Vertex } grip) return [Reshaped(drawing, own, grip, to)];
        var ends = grips.SelectMany(hot => hot.Kind == GripKind.Side ? EndsOf(drawing, hot.Part) : [hot.Place]).ToList();
        return parts.Select(part => Stretched(drawing, part, ends, to - place)).OfType<ChangedPart>();
    }

    private static Point2D[] EndsOf(Drawing drawing, int part)
    {
        var segment = drawing.SegmentOf(drawing.Parts[part]);
        return [segment.Start, segment.End];
    }

    /// <summary>Null if neither end moves.</summary>
    private static ChangedPart? Stretched(Drawing drawing, int index, List<Point2D> moving, Vector2D way)
    {
        ref var part = ref drawing.Parts[index];
        var segment = drawing.SegmentOf(part);
        if (segment.IsClosed) return null;
        var (start, end) = (moving.Exists(place => ObjectGrips.Coincide(place, segment.Start)), moving.Exists(place => ObjectGrips.Coincide(place, segment.End)));
        if (!start && !end) return null;
        if (start && end) return ChangedPart.Moved(drawing, index, way);
        if (part.IsFreeCurve && part.Kind != SegmentKind.Spline) return ChangedPart.Vanished(index); // One bent span of an elliptical arc would not be an ellipse.
        return part.IsFreeCurve ? new ChangedPart(index, part, BentEnd(segment.Curve, start, way)) : Between(index, part, start ? segment.Start + way : segment.Start, end ? segment.End + way : segment.End);
    }

    /// <summary>A line, or an arc of the same included angle, between two points.</summary>
    private static ChangedPart Between(int index, in DrawingPart part, Point2D start, Point2D end)
    {
        if (part.Kind == SegmentKind.Line) return new ChangedPart(index, DrawingPart.Line(part.Entity, start.X, start.Y, part.C, end.X, end.Y, part.F), null);
        if (start == end) return ChangedPart.Vanished(index);
        var quarter = Angle.FromDegrees(part.F / 4.0);
        return new ChangedPart(index, DrawingPart.Arc(part.Entity, ArcSegment.FromBulge(start, end, quarter.Sin() / quarter.Cos()), part.C), null);
    }

    private static ChangedPart Reshaped(Drawing drawing, int index, Grip grip, Point2D to)
    {
        var part = drawing.Parts[index];
        var segment = drawing.SegmentOf(part);
        if (grip.Kind == GripKind.Axis && ObjectGrips.CentreOf(segment) is { } centre && centre.DistanceTo(to) < EllipseConstruction.Flattest * centre.DistanceTo(grip.Place)) return ChangedPart.Vanished(index);
        if (grip.Kind == GripKind.Axis) return new ChangedPart(index, part, WithAxis(segment, grip.Place, to));
        if (grip.Kind == GripKind.Radius) return new ChangedPart(index, DrawingPart.Arc(part.Entity, segment.Arc with { Radius = segment.Arc.Centre.DistanceTo(to) }, part.C), null);
        var bulge = BulgeThrough(segment.Start, segment.End, to);
        if (Math.Abs(bulge) is >= MinBulge and <= 1.0 / MinBulge) return new ChangedPart(index, DrawingPart.Arc(part.Entity, ArcSegment.FromBulge(segment.Start, segment.End, bulge), part.C), null);
        return Math.Abs(bulge) < MinBulge && drawing.Entities[grip.Entity].PartCount > 1 ? new ChangedPart(index, DrawingPart.Line(part.Entity, segment.Start.X, segment.Start.Y, part.C, segment.End.X, segment.End.Y, part.C), null) : ChangedPart.Vanished(index);
    }

    /// <summary>Bulge (tangent of a quarter of the sweep) of the arc from one point to another through a third; 0 if they are collinear.</summary>
    /// <remarks>From the third point the chord subtends half of the remaining turn: sweep = 360 degrees - 2 x that angle, by the theorem of the inscribed
    /// angle.</remarks>
    private static double BulgeThrough(Point2D start, Point2D end, Point2D through)
    {
        var (a, b) = (start - through, end - through);
        var seen = Math.Atan2(Math.Abs(a.Cross(b)), a.Dot(b));
        var bulge = Math.Tan((Math.PI - seen) / 2.0);
        return a.Cross(b) > 0.0 ? -bulge : bulge; // A point to the left of the chord: clockwise.
    }

    /// <summary>An open spline whose first or last control point has moved.</summary>
    private static RationalCurve BentEnd(RationalCurve curve, bool atStart, Vector2D way)
    {
        BezierSpan[] spans = [.. curve.Spans];
        ref var span = ref spans[atStart ? 0 : ^1];
        double[] points = [.. span.Homogeneous];
        var at = atStart ? 0 : points.Length - BezierSpan.Stride;
        (points[at], points[at + 1]) = (points[at] + (way.X * points[at + 3]), points[at + 1] + (way.Y * points[at + 3]));
        span = new BezierSpan(points);
        return new RationalCurve(curve.Kind, spans);
    }

    /// <summary>A full ellipse whose axis through one point has the distance of another point from the centre as length.</summary>
    private static RationalCurve WithAxis(in Segment segment, Point2D axisEnd, Point2D to)
    {
        var centre = ObjectGrips.CentreOf(segment)!.Value;
        var (axis, factor) = (axisEnd - centre, centre.DistanceTo(to) / centre.DistanceTo(axisEnd));
        var direction = axis * (1.0 / axis.Length);
        return segment.Curve.With([.. segment.Curve.Spans.ToArray().Select(span => Stretched(span, centre, direction, factor))]);
    }

    private static BezierSpan Stretched(BezierSpan span, Point2D centre, Vector2D direction, double factor)
    {
        double[] points = [.. span.Homogeneous];
        for (var at = 0; at < points.Length; at += BezierSpan.Stride)
        {
            var weight = points[at + 3];
            var more = (factor - 1.0) * new Vector2D(points[at] - (centre.X * weight), points[at + 1] - (centre.Y * weight)).Dot(direction);
            (points[at], points[at + 1]) = (points[at] + (more * direction.X), points[at + 1] + (more * direction.Y));
        }

        return new BezierSpan(points);
    }
}
