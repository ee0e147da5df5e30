using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Picking;

/// <summary>The snap points of one segment.</summary>
internal static class SnapPlaces
{
    private const int SpansOfWholeEllipse = 4;

    public static IEnumerable<SnapPoint> Find(Segment segment)
    {
        if (!segment.IsClosed)
        {
            yield return new SnapPoint(segment.Start, SnapKinds.End);
            yield return new SnapPoint(segment.End, SnapKinds.End);
            yield return new SnapPoint(MiddleOf(segment), SnapKinds.Middle);
        }

        foreach (var quadrant in QuadrantsOf(segment)) yield return new SnapPoint(quadrant, SnapKinds.Quadrant);
        if (CentreOf(segment) is { } centre) yield return new SnapPoint(centre, SnapKinds.Centre);
    }

    /// <summary>Centre of an arc, a circle or a whole ellipse; null for anything else.</summary>
    public static Point2D? CentreOf(Segment segment)
    {
        if (segment.Kind is SegmentKind.Arc or SegmentKind.Circle) return segment.Arc.Centre;
        if (segment.Kind != SegmentKind.Ellipse || !segment.IsClosed || segment.Curve.Spans.Length != SpansOfWholeEllipse) return null;
        var (a, b) = (segment.Curve.Spans[0].Start, segment.Curve.Spans[2].Start);
        return new Point2D((a.X + b.X) / 2.0, (a.Y + b.Y) / 2.0);
    }

    /// <summary>Midpoint of a line or arc; for a spline, the middle of its parameter range.</summary>
    private static Point2D MiddleOf(Segment segment) => segment.PointAt(0.5);

    private static IEnumerable<Point2D> QuadrantsOf(Segment segment)
    {
        if (segment.Kind == SegmentKind.Ellipse && segment.IsClosed)
        {
            for (var i = 0; i < segment.Curve.Spans.Length; i++) yield return segment.Curve.Spans[i].Start;
        }

        if (segment.Kind is not (SegmentKind.Arc or SegmentKind.Circle)) yield break;
        for (var quadrant = 0; quadrant < 4; quadrant++)
        {
            var direction = Angle.FromDegrees(90.0 * quadrant);
            if (segment.Arc.Covers(direction)) yield return segment.Arc.Centre + Vector2D.FromPolar(segment.Arc.Radius, direction);
        }
    }
}
