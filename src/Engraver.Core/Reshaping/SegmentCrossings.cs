using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>Points where two segments cross or touch. Lines, arcs and circles exactly; an ellipse or spline with one of these by halving
/// (<see cref="CurveCrossings"/>), and not with another free curve.</summary>
public static class SegmentCrossings
{
    /// <summary>Allowed distance of a crossing beyond an end, as a fraction of the segment's size: only rounding.</summary>
    private const double Slack = 1e-9;

    /// <summary>Largest distance at which a line and a circle, or two circles, still touch, as a fraction of the coordinates: only rounding.</summary>
    private const double Touch = 1e-14;

    /// <summary>The places on both segments.</summary>
    public static IEnumerable<Point2D> Find(Segment a, Segment b) => Carriers(a, b).Where(place => IsOn(a, place) && IsOn(b, place));

    /// <summary>The places where the whole line or circle under one meets that under the other, within the segments or beyond their ends. An ellipse or spline
    /// ends at its ends.</summary>
    public static IEnumerable<Point2D> Carriers(Segment a, Segment b)
    {
        if (a.IsFreeCurve || b.IsFreeCurve) return (a.IsFreeCurve, b.IsFreeCurve) switch
        {
            (true, false) => CurveCrossings.Find(a.Curve, b).Select(a.Curve.PointAt),
            (false, true) => CurveCrossings.Find(b.Curve, a).Select(b.Curve.PointAt),
            _ => [],
        };
        return (a.Kind == SegmentKind.Line, b.Kind == SegmentKind.Line) switch
        {
            (true, true) => LineAndLine(a.Line, b.Line),
            (true, false) => LineAndCircle(a.Line, b.Arc),
            (false, true) => LineAndCircle(b.Line, a.Arc),
            _ => CircleAndCircle(a.Arc, b.Arc),
        };
    }

    /// <summary>True when a place is on the segment within rounding.</summary>
    public static bool IsOn(Segment segment, Point2D place)
    {
        var box = segment.Bounds;
        return segment.DistanceTo(place) <= Slack * (box.Width + box.Height + Math.Abs(place.X) + Math.Abs(place.Y));
    }

    private static IEnumerable<Point2D> LineAndLine(LineSegment a, LineSegment b)
    {
        var (along, other) = (a.End - a.Start, b.End - b.Start);
        var cross = along.Cross(other);
        if (Math.Abs(cross) <= Touch * along.Length * other.Length) yield break;
        yield return a.Start + (along * ((b.Start - a.Start).Cross(other) / cross));
    }

    private static IEnumerable<Point2D> LineAndCircle(LineSegment line, ArcSegment circle)
    {
        var along = line.End - line.Start;
        var squared = along.LengthSquared;
        if (squared == 0.0) yield break;
        var foot = line.Start + (along * ((circle.Centre - line.Start).Dot(along) / squared));
        var off = foot.DistanceTo(circle.Centre);
        if (off > circle.Radius + Rounding(foot, circle)) yield break;
        var half = along * (Math.Sqrt(Math.Max(0.0, (circle.Radius - off) * (circle.Radius + off))) / Math.Sqrt(squared));
        yield return foot + half;
        if (half != default) yield return foot - half;
    }

    private static IEnumerable<Point2D> CircleAndCircle(ArcSegment a, ArcSegment b)
    {
        var between = b.Centre - a.Centre;
        var (distance, slack) = (between.Length, Rounding(b.Centre, a));
        if (distance <= slack || distance > a.Radius + b.Radius + slack || distance < Math.Abs(a.Radius - b.Radius) - slack) yield break;
        var along = ((a.Radius * a.Radius) - (b.Radius * b.Radius) + (distance * distance)) / (2.0 * distance);
        var half = Math.Sqrt(Math.Max(0.0, (a.Radius - along) * (a.Radius + along)));
        var direction = between * (1.0 / distance);
        var foot = a.Centre + (direction * along);
        yield return foot + new Vector2D(-direction.Y * half, direction.X * half);
        if (half > 0.0) yield return foot - new Vector2D(-direction.Y * half, direction.X * half);
    }

    private static double Rounding(Point2D place, ArcSegment circle) => Touch * (circle.Radius + Math.Abs(place.X) + Math.Abs(place.Y) + Math.Abs(circle.Centre.X) + Math.Abs(circle.Centre.Y));
}
