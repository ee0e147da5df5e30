using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Objects;

/// <summary>The grips of selected objects: the points by which they can be dragged. Drawing units.</summary>
/// <remarks>A line has its ends (stretch) and its middle (move); an arc its ends, a middle that bends it and its centre; a circle its centre and its four
/// quadrants; a polyline its vertices and the middles of its sides; a full ellipse its centre and the ends of its axes; an open spline its ends and a middle
/// that moves it; any other curve a middle that moves it.</remarks>
public static class ObjectGrips
{
    /// <summary>Maximum number of selected objects with grips (AutoCAD's GRIPOBJLIMIT).</summary>
    public const int MaxObjects = 100;

    /// <summary>Maximum number of shown grips.</summary>
    private const int MaxGrips = 2000;

    /// <summary>Tolerance for coincident grips, relative to their coordinates.</summary>
    private const double CoincidenceTolerance = 1e-9;

    private const int SpansOfWholeEllipse = 4;

    /// <summary>The grips of a selection, in its order; empty for a large selection, without objects on locked layers.</summary>
    public static IEnumerable<Grip> Find(Drawing drawing, IReadOnlyList<int> selection)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(selection);
        return selection.Count > MaxObjects ? [] : selection.Where(entity => entity < drawing.Entities.Count && !drawing.Layers[drawing.Entities[entity].Layer].Locked).SelectMany(entity => Find(drawing, entity)).Take(MaxGrips);
    }

    /// <summary>The grips hit by a press at a point: the nearest one and all coincident ones; empty if the nearest is farther away than
    /// <paramref name="reach"/>.</summary>
    public static IReadOnlyList<Grip> At(Drawing drawing, IReadOnlyList<int> selection, Point2D place, double reach)
    {
        var all = Find(drawing, selection).ToList();
        if (all.Count == 0) return [];
        var nearest = all.MinBy(grip => grip.Place.DistanceTo(place));
        return nearest.Place.DistanceTo(place) > reach ? [] : [.. all.Where(grip => Coincide(grip.Place, nearest.Place))];
    }

    internal static bool Coincide(Point2D a, Point2D b) => a.DistanceTo(b) <= CoincidenceTolerance * (1.0 + Math.Max(Math.Abs(a.X) + Math.Abs(a.Y), Math.Abs(b.X) + Math.Abs(b.Y)));

    private static IEnumerable<Grip> Find(Drawing drawing, int entity)
    {
        var (first, count) = (drawing.Entities[entity].FirstPart, drawing.Entities[entity].PartCount);
        for (var part = first; part < first + count; part++)
        {
            var segment = drawing.SegmentOf(drawing.Parts[part]);
            var grips = segment.IsFreeCurve ? OfCurve(segment) : segment.Kind switch
            {
                SegmentKind.Line => [(GripKind.Vertex, segment.Start), (GripKind.Vertex, segment.End), (count == 1 ? GripKind.Whole : GripKind.Side, segment.PointAt(0.5))],
                SegmentKind.Circle => [(GripKind.Whole, segment.Arc.Centre), .. Quadrants(segment.Arc)],
                _ => count == 1
                    ? [(GripKind.Vertex, segment.Start), (GripKind.Vertex, segment.End), (GripKind.Bulge, segment.PointAt(0.5)), (GripKind.Whole, segment.Arc.Centre)]
                    : [(GripKind.Vertex, segment.Start), (GripKind.Vertex, segment.End), (GripKind.Bulge, segment.PointAt(0.5))],
            };
            foreach (var (kind, place) in grips) yield return new Grip(entity, part, kind, place);
        }
    }

    private static IEnumerable<(GripKind, Point2D)> OfCurve(Segment segment)
    {
        if (CentreOf(segment) is { } centre) return [(GripKind.Whole, centre), .. AxisEnds(segment.Curve)];
        return segment is { Kind: SegmentKind.Spline, IsClosed: false } ? [(GripKind.Vertex, segment.Start), (GripKind.Vertex, segment.End), (GripKind.Whole, segment.PointAt(0.5))] : [(GripKind.Whole, segment.PointAt(0.5))];
    }

    /// <summary>Centre of a full ellipse; null for any other curve.</summary>
    internal static Point2D? CentreOf(in Segment segment)
    {
        if (segment.Kind != SegmentKind.Ellipse || !segment.IsClosed || segment.Curve.Spans.Length != SpansOfWholeEllipse) return null;
        var (a, b) = (segment.Curve.Spans[0].Start, segment.Curve.Spans[2].Start);
        return new Point2D((a.X + b.X) / 2.0, (a.Y + b.Y) / 2.0);
    }

    private static IEnumerable<(GripKind, Point2D)> AxisEnds(RationalCurve curve) => Enumerable.Range(0, curve.Spans.Length).Select(span => (GripKind.Axis, curve.Spans[span].Start));

    private static IEnumerable<(GripKind, Point2D)> Quadrants(ArcSegment circle) =>
        Enumerable.Range(0, 4).Select(quadrant => (GripKind.Radius, circle.Centre + Vector2D.FromPolar(circle.Radius, Angle.FromDegrees(90.0 * quadrant))));
}
