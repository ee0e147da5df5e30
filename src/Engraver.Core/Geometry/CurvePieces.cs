namespace Engraver.Core.Geometry;

/// <summary>Divides curves into pieces that are nearly straight, so that their boxes are small, and of nearly constant speed, so that equal steps of the
/// parameter are nearly equal lengths.</summary>
public static class CurvePieces
{
    /// <summary>Largest distance of a control point from the chord, as a part of the chord.</summary>
    private const double Flatness = 0.1;

    private const int MaxHalvings = 14;

    /// <summary>Smallest cosine of the angle between a leg of the control polygon and the chord.</summary>
    private const double MinAlong = 0.85;

    /// <summary>Longest leg of the control polygon as a multiple of the average, and largest weight as a multiple of the smallest.</summary>
    private const double Evenness = 3.0;

    /// <summary>The size of a piece smaller than this part of its coordinates is rounding; it is not divided.</summary>
    private const double NegligibleLength = 1e-12;

    /// <summary>Lines, arcs and circles unchanged, every curve as its pieces.</summary>
    public static IReadOnlyList<Segment> Split(IReadOnlyList<Segment> segments)
    {
        if (!segments.Any(segment => segment.IsFreeCurve)) return segments;
        var pieces = new List<Segment>(segments.Count);
        foreach (var segment in segments)
        {
            if (segment.IsFreeCurve) pieces.AddRange(segment.Curve.Pieces().Select(Segment.FromCurve));
            else pieces.Add(segment);
        }

        return pieces;
    }

    internal static RationalCurve[] Split(RationalCurve curve)
    {
        var pieces = new List<RationalCurve>();
        foreach (var span in curve.Spans) Divide(curve.Kind, span, MaxHalvings, pieces);
        return [.. pieces];
    }

    private static void Divide(SegmentKind kind, BezierSpan span, int halvings, List<RationalCurve> pieces)
    {
        if (halvings == 0 || IsNegligible(span) || (IsFlat(span) && IsEven(span)))
        {
            pieces.Add(new RationalCurve(kind, [span]));
            return;
        }

        var (first, second) = span.Halves();
        Divide(kind, first, halvings - 1, pieces);
        Divide(kind, second, halvings - 1, pieces);
    }

    private static bool IsNegligible(BezierSpan span)
    {
        var (hull, start) = (CurveBounds.Hull(span), span.Start);
        return hull.Width + hull.Height <= NegligibleLength * (Math.Abs(start.X) + Math.Abs(start.Y));
    }

    /// <summary>True when no control point is far from the chord and no leg of the control polygon far from its direction.</summary>
    private static bool IsFlat(BezierSpan span)
    {
        var chord = new LineSegment(span.Start, span.End);
        var (way, length) = (span.End - span.Start, chord.Length);
        for (var i = 1; i <= span.Degree; i++)
        {
            var leg = span.Control(i) - span.Control(i - 1);
            if (leg.Dot(way) < MinAlong * leg.Length * length) return false;
            if (i < span.Degree && chord.DistanceTo(span.Control(i)) > Flatness * length) return false;
        }

        return true;
    }

    /// <summary>True when the speed is nowhere much above its average, so that steps of the parameter do not skip any part. It may be lower, down to
    /// zero.</summary>
    private static bool IsEven(BezierSpan span)
    {
        var (longest, least, most) = (0.0, span.Weight(0), span.Weight(0));
        for (var i = 1; i <= span.Degree; i++)
        {
            longest = Math.Max(longest, span.Control(i).DistanceTo(span.Control(i - 1)));
            (least, most) = (Math.Min(least, span.Weight(i)), Math.Max(most, span.Weight(i)));
        }

        return longest * span.Degree <= Evenness * span.Start.DistanceTo(span.End) && most <= Evenness * least;
    }
}
