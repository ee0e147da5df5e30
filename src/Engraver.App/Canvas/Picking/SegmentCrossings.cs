using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Picking;

/// <summary>Where two lines, arcs or circles cross or touch. Ellipses and splines have no intersections here.</summary>
internal static class SegmentCrossings
{
    /// <summary>How far a crossing may lie off an end, as a part of the segment's size: rounding, no more.</summary>
    private const double Slack = 1e-9;

    public static IEnumerable<Point2D> Find(Segment a, Segment b)
    {
        if (a.IsFreeCurve || b.IsFreeCurve) return [];
        var candidates = (a.Kind == SegmentKind.Line, b.Kind == SegmentKind.Line) switch
        {
            (true, true) => LineAndLine(a.Line, b.Line),
            (true, false) => LineAndCircle(a.Line, b.Arc),
            (false, true) => LineAndCircle(b.Line, a.Arc),
            _ => CircleAndCircle(a.Arc, b.Arc),
        };
        return candidates.Where(place => IsOn(a, place) && IsOn(b, place));
    }

    private static bool IsOn(Segment segment, Point2D place)
    {
        var box = segment.Bounds;
        return segment.DistanceTo(place) <= Slack * (box.Width + box.Height + Math.Abs(place.X) + Math.Abs(place.Y));
    }

    private static IEnumerable<Point2D> LineAndLine(LineSegment a, LineSegment b)
    {
        var (along, other) = (a.End - a.Start, b.End - b.Start);
        var cross = along.Cross(other);
        if (cross == 0.0) yield break;
        yield return a.Start + (along * ((b.Start - a.Start).Cross(other) / cross));
    }

    private static IEnumerable<Point2D> LineAndCircle(LineSegment line, ArcSegment circle)
    {
        var along = line.End - line.Start;
        var squared = along.LengthSquared;
        if (squared == 0.0) yield break;
        var foot = line.Start + (along * ((circle.Centre - line.Start).Dot(along) / squared));
        var off = foot.DistanceTo(circle.Centre);
        if (off > circle.Radius) yield break;
        var half = along * (Math.Sqrt((circle.Radius - off) * (circle.Radius + off)) / Math.Sqrt(squared));
        yield return foot + half;
        yield return foot - half;
    }

    private static IEnumerable<Point2D> CircleAndCircle(ArcSegment a, ArcSegment b)
    {
        var between = b.Centre - a.Centre;
        var distance = between.Length;
        if (distance == 0.0 || distance > a.Radius + b.Radius || distance < Math.Abs(a.Radius - b.Radius)) yield break;
        var along = ((a.Radius * a.Radius) - (b.Radius * b.Radius) + (distance * distance)) / (2.0 * distance);
        var half = Math.Sqrt(Math.Max(0.0, (a.Radius - along) * (a.Radius + along)));
        var direction = between * (1.0 / distance);
        var foot = a.Centre + (direction * along);
        yield return foot + new Vector2D(-direction.Y * half, direction.X * half);
        yield return foot - new Vector2D(-direction.Y * half, direction.X * half);
    }
}
