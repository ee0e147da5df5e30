namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Spans of a curve from one corner to the next. A place on it is the number of the span plus the parameter in it, from 0 to
/// <see cref="End"/>.</summary>
internal sealed class SmoothRun(ArraySegment<BezierSpan> spans)
{
    /// <summary>Sine of the turn above which a joint of spans is a corner; below it, coordinates rounded in the file may be the cause.</summary>
    public const double CornerSine = 1e-3;

    public double End => spans.Count;

    /// <summary>Divides a curve into runs: where spans do not meet, or meet at an angle.</summary>
    public static IEnumerable<SmoothRun> Split(RationalCurve curve)
    {
        var spans = curve.Spans.ToArray();
        var first = 0;
        for (var i = 1; i <= spans.Length; i++)
        {
            if (i < spans.Length && IsSmooth(spans[i - 1], spans[i])) continue;
            yield return new SmoothRun(new ArraySegment<BezierSpan>(spans, first, i - first));
            first = i;
        }
    }

    /// <summary>The same run from its end to its start.</summary>
    public SmoothRun Reversed() => new(spans.Reverse().Select(span => span.Reversed()).ToArray());

    public Point2D PlaceAt(double place)
    {
        var span = Math.Min((int)place, spans.Count - 1);
        return place == span ? spans[span].Start : place >= End ? spans[span].End : spans[span].PointAt(place - span);
    }

    /// <summary>Direction of travel (length 1); where the speed is zero, the direction in which the run continues.</summary>
    public Vector2D TangentAt(double place)
    {
        var span = Math.Min((int)place, spans.Count - 1);
        return spans[span].TangentAt(place - span);
    }

    /// <summary>The part between two places, span by span.</summary>
    public IEnumerable<BezierSpan> Between(double from, double to)
    {
        for (var span = (int)from; span < to && span < spans.Count; span++)
        {
            yield return spans[span].Part(Math.Max(0.0, from - span), Math.Min(1.0, to - span));
        }
    }

    private static bool IsSmooth(BezierSpan before, BezierSpan after)
    {
        var (arriving, leaving) = (before.EndTangent, after.StartTangent);
        var (end, start) = (before.End, after.Start);
        return end.IsNear(start, 1e-12 * (Math.Abs(start.X) + Math.Abs(start.Y) + before.Start.DistanceTo(end)))
            && Math.Abs(arriving.Cross(leaving)) <= CornerSine && arriving.Dot(leaving) > 0.0;
    }
}
