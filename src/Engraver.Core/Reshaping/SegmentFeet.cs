using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>Points where a line from a place is perpendicular or tangent to a segment: the object snaps PER and TAN.</summary>
public static class SegmentFeet
{
    /// <summary>The places at which a line from here is perpendicular to the segment. For a line also beyond its ends, as in AutoCAD.</summary>
    public static IEnumerable<Point2D> Perpendicular(Segment segment, Point2D from)
    {
        if (segment.Kind == SegmentKind.Line) return segment.Length == 0.0 ? [] : [segment.Start + ((segment.End - segment.Start) * PathPlace.FractionOf(segment, from))];
        if (segment.IsFreeCurve) return OfCurve(segment.Curve, (place, tangent) => (place - from).Dot(tangent));
        var spoke = from - segment.Arc.Centre;
        return spoke == default ? [] : OnArc(segment.Arc, [spoke.Direction, spoke.Direction + Angle.FromDegrees(180.0)]);
    }

    /// <summary>The places at which a line from here touches an arc, circle, ellipse or spline; none for a line, and none from within a circle.</summary>
    public static IEnumerable<Point2D> Tangent(Segment segment, Point2D from)
    {
        if (segment.Kind == SegmentKind.Line) return [];
        if (segment.IsFreeCurve) return OfCurve(segment.Curve, (place, tangent) => (place - from).Cross(tangent));
        var spoke = from - segment.Arc.Centre;
        if (spoke.Length <= segment.Arc.Radius) return [];
        var aside = Angle.FromRadians(Math.Acos(segment.Arc.Radius / spoke.Length));
        return OnArc(segment.Arc, [spoke.Direction + aside, spoke.Direction - aside]);
    }

    private static IEnumerable<Point2D> OnArc(ArcSegment arc, IEnumerable<Angle> directions) =>
        directions.Where(arc.Covers).Select(direction => arc.Centre + Vector2D.FromPolar(arc.Radius, direction));

    private static IEnumerable<Point2D> OfCurve(RationalCurve curve, Func<Point2D, Vector2D, double> value) =>
        CurveRoots.Find(curve.Spans.Length, fraction => value(curve.PointAt(fraction), curve.TangentAt(fraction))).Select(curve.PointAt);
}
