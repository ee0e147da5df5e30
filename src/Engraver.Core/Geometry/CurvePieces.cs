namespace Engraver.Core.Geometry;

/// <summary>Takes curves apart into nearly straight pieces, on which the nearest place is easily found.</summary>
public static class CurvePieces
{
    /// <summary>Largest distance of a control point from the chord, as a part of the chord.</summary>
    private const double Flatness = 0.1;

    private const int MostHalvings = 14;
    private const int NewtonSteps = 6;

    /// <summary>Lines, arcs and circles as they are, every curve as its pieces.</summary>
    public static IReadOnlyList<Segment> Of(IReadOnlyList<Segment> segments)
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

    internal static RationalCurve[] Of(RationalCurve curve)
    {
        var pieces = new List<RationalCurve>();
        foreach (var span in curve.Spans) Divide(curve.Kind, span, MostHalvings, pieces);
        return [.. pieces];
    }

    /// <summary>Distance to a flat piece: never less than the true one, and the true one to rounding near the curve.</summary>
    internal static double Distance(BezierSpan piece, Point2D place)
    {
        var (start, end) = (piece.Start, piece.End);
        var best = Math.Min(start.DistanceTo(place), end.DistanceTo(place));
        var chord = end - start;
        var parameter = chord == default ? 0.5 : Math.Clamp((place - start).Dot(chord) / chord.LengthSquared, 0.0, 1.0);
        for (var step = 0; step < NewtonSteps; step++)
        {
            var found = piece.Evaluate(parameter, out var derivative);
            best = Math.Min(best, found.DistanceTo(place));
            var speed = derivative.LengthSquared;
            if (speed == 0.0) break;
            var next = Math.Clamp(parameter + ((place - found).Dot(derivative) / speed), 0.0, 1.0);
            if (next == parameter) break;
            parameter = next;
        }

        return best;
    }

    private static void Divide(SegmentKind kind, BezierSpan span, int halvings, List<RationalCurve> pieces)
    {
        if (halvings == 0 || IsFlat(span))
        {
            pieces.Add(new RationalCurve(kind, [span]));
            return;
        }

        var (first, second) = span.Halves();
        Divide(kind, first, halvings - 1, pieces);
        Divide(kind, second, halvings - 1, pieces);
    }

    private static bool IsFlat(BezierSpan span)
    {
        var chord = new LineSegment(span.Start, span.End);
        var within = Flatness * chord.Length;
        for (var i = 1; i < span.Degree; i++)
        {
            if (chord.DistanceTo(span.Control(i)) > within) return false;
        }

        return true;
    }
}
