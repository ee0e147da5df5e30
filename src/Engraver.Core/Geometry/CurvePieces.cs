namespace Engraver.Core.Geometry;

/// <summary>Takes curves apart into nearly straight pieces, on which the nearest place is easily found.</summary>
public static class CurvePieces
{
    /// <summary>Largest distance of a control point from the chord, as a part of the chord.</summary>
    private const double Flatness = 0.1;

    private const int MostHalvings = 14;
    private const int MostSteps = 60;

    /// <summary>Cosine of the largest angle between a leg of the control polygon and the chord.</summary>
    private const double LeastAlong = 0.85;

    private const double ParameterKnown = 1e-13;

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
        var ends = Math.Min(piece.Start.DistanceTo(place), piece.End.DistanceTo(place));
        if (!(Ahead(piece, 0.0, place, out _) > 0.0) || !(Ahead(piece, 1.0, place, out _) < 0.0)) return ends;
        return Math.Min(ends, AtFoot(piece, place));
    }

    /// <summary>Newton's steps to the foot of the perpendicular, kept between two parameters on either side of it: a sharp bend at an end must not throw them off.</summary>
    private static double AtFoot(BezierSpan piece, Point2D place)
    {
        var (low, high) = (0.0, 1.0);
        var chord = piece.End - piece.Start;
        var parameter = Math.Clamp((place - piece.Start).Dot(chord) / chord.LengthSquared, 0.0, 1.0);
        var (best, before) = (double.PositiveInfinity, double.PositiveInfinity);
        for (var step = 0; step < MostSteps && low < high; step++)
        {
            var ahead = Ahead(piece, parameter, place, out var found);
            best = Math.Min(best, found.Distance);
            if (ahead == 0.0) break;
            if (ahead > 0.0) low = parameter;
            else high = parameter;
            var next = parameter + (ahead / found.Speed);
            if (Math.Abs(next - parameter) <= ParameterKnown) break;
            if (!(next > low && next < high) || Math.Abs(ahead) > before / 2.0) next = (low + high) / 2.0;
            (parameter, before) = (next, Math.Abs(ahead));
        }

        return best;
    }

    /// <summary>How far the place lies ahead of a point of the piece, times the speed there.</summary>
    private static double Ahead(BezierSpan piece, double parameter, Point2D place, out (double Distance, double Speed) found)
    {
        var point = piece.Evaluate(parameter, out var derivative);
        found = (point.DistanceTo(place), derivative.LengthSquared);
        return (place - point).Dot(derivative);
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

    /// <summary>No control point far from the chord and no leg of the control polygon far from its direction: a place near the piece has one foot on it.</summary>
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
}
