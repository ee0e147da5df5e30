namespace Engraver.Core.Geometry;

/// <summary>Takes curves apart into pieces that are nearly straight, so that their boxes are tight, and nearly even in speed, so that steps of the parameter are steps along them.</summary>
public static class CurvePieces
{
    /// <summary>Largest distance of a control point from the chord, as a part of the chord.</summary>
    private const double Flatness = 0.1;

    private const int MostHalvings = 14;

    /// <summary>Cosine of the largest angle between a leg of the control polygon and the chord.</summary>
    private const double LeastAlong = 0.85;

    /// <summary>Largest leg of the control polygon as a multiple of an even one, and largest weight of that of the smallest.</summary>
    private const double Evenness = 3.0;

    /// <summary>Of its coordinates: what is smaller is rounding, and has no shape to be divided.</summary>
    private const double Speck = 1e-12;

    /// <summary>Lines, arcs and circles as they are, every curve as its pieces.</summary>
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
        foreach (var span in curve.Spans) Divide(curve.Kind, span, MostHalvings, pieces);
        return [.. pieces];
    }

    private static void Divide(SegmentKind kind, BezierSpan span, int halvings, List<RationalCurve> pieces)
    {
        if (halvings == 0 || IsSpeck(span) || (IsFlat(span) && IsEven(span)))
        {
            pieces.Add(new RationalCurve(kind, [span]));
            return;
        }

        var (first, second) = span.Halves();
        Divide(kind, first, halvings - 1, pieces);
        Divide(kind, second, halvings - 1, pieces);
    }

    private static bool IsSpeck(BezierSpan span)
    {
        var (hull, start) = (CurveBounds.Hull(span), span.Start);
        return hull.Width + hull.Height <= Speck * (Math.Abs(start.X) + Math.Abs(start.Y));
    }

    /// <summary>No control point far from the chord and no leg of the control polygon far from its direction.</summary>
    private static bool IsFlat(BezierSpan span)
    {
        var chord = new LineSegment(span.Start, span.End);
        var (way, length) = (span.End - span.Start, chord.Length);
        for (var i = 1; i <= span.Degree; i++)
        {
            var leg = span.Control(i) - span.Control(i - 1);
            if (leg.Dot(way) < LeastAlong * leg.Length * length) return false;
            if (i < span.Degree && chord.DistanceTo(span.Control(i)) > Flatness * length) return false;
        }

        return true;
    }

    /// <summary>Nowhere much faster than on the average: whoever walks it in steps of the parameter jumps over nothing. Slower it may be, down to standing still.</summary>
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
