namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Decides whether a piece of a curve is within a distance of an arc (or line), rigorously: not at samples but by bounds that hold
/// everywhere.</summary>
/// <remarks>
/// With Q the vector from the arc's start, n its left normal there and k its curvature, d = k|Q|^2 - 2 Q.n is 2 + k e times the distance e from the circle (k =
/// 0: from the line). Times the squared weight it is a polynomial, which its Bernstein coefficients enclose, as are the distances by which the piece may extend
/// beyond the arc's two ends. Pieces that the bounds do not decide are halved. Since piece and arc begin and end beside each other, every point of the arc has
/// a point of the piece as near (continuity).
/// </remarks>
internal static class ArcDeviation
{
    /// <summary>Part of the tolerance by which a piece may extend beyond the ends of its arc; the rest is for the distance from it.</summary>
    public const double EndShare = 0.02;

    private const int MaxHalvings = 7;

    public static bool IsWithin(BezierSpan piece, in TangentArc arc, double tolerance) => IsWithin(piece, arc, tolerance, MaxHalvings);

    private static bool IsWithin(BezierSpan piece, in TangentArc arc, double tolerance, int halvings)
    {
        var (largest, sampled) = Distance(piece, arc);
        var overshoot = Overshoot(piece, arc);
        if (largest <= (1.0 - EndShare) * tolerance && overshoot <= EndShare * tolerance) return true;
        if (!(sampled <= tolerance) || halvings == 0) return false;
        var (first, second) = piece.Halves();
        return IsWithin(first, arc, tolerance, halvings - 1) && IsWithin(second, arc, tolerance, halvings - 1);
    }

    /// <summary>An upper bound of the distance from circle or line over the piece, and the larger of the distances at its two ends.</summary>
    private static (double Bound, double AtEnds) Distance(BezierSpan piece, in TangentArc arc)
    {
        var degree = piece.Degree;
        Span<double> x = stackalloc double[degree + 1];
        Span<double> y = stackalloc double[degree + 1];
        Span<double> line = stackalloc double[degree + 1];
        var least = double.PositiveInfinity;
        for (var i = 0; i <= degree; i++)
        {
            var weight = piece.Weight(i);
            least = Math.Min(least, weight);
            (x[i], y[i]) = (piece.Homogeneous[i * BezierSpan.Stride] - (arc.Start.X * weight), piece.Homogeneous[(i * BezierSpan.Stride) + 1] - (arc.Start.Y * weight));
            line[i] = 2.0 * ((x[i] * -arc.StartTangent.Y) + (y[i] * arc.StartTangent.X));
        }

        var largest = 0.0;
        for (var k = 0; k <= 2 * degree; k++)
        {
            var sum = 0.0;
            for (var i = Math.Max(0, k - degree); i <= Math.Min(degree, k); i++)
            {
                var share = Bernstein.Binomials[degree][i] * Bernstein.Binomials[degree][k - i];
                sum += share * ((arc.Curvature * ((x[i] * x[k - i]) + (y[i] * y[k - i]))) - (piece.Weight(i) * line[k - i]));
            }

            largest = Math.Max(largest, Math.Abs(sum) / Bernstein.Binomials[2 * degree][k]);
        }

        return (ToDistance(largest / (least * least), arc.Curvature), Math.Max(AtEnd(piece.Start, arc), AtEnd(piece.End, arc)));
    }

    /// <summary>The distance |e| that belongs to d, from |d| = |e| (2 + k e) with k e at least -1.</summary>
    private static double ToDistance(double d, double curvature) => d / (2.0 - Math.Min(1.0, Math.Abs(curvature) * d));

    /// <summary>Distance of a point from the arc's whole circle (or line).</summary>
    public static double FromCircle(Point2D place, in TangentArc arc)
    {
        var way = place - arc.Start;
        var d = (arc.Curvature * way.LengthSquared) - (2.0 * arc.StartTangent.Cross(way));
        return Math.Abs(d) / (1.0 + Math.Sqrt(Math.Max(0.0, 1.0 + (arc.Curvature * d))));
    }

    private static double AtEnd(Point2D place, in TangentArc arc)
    {
        var way = place - arc.Start;
        return Math.Abs((arc.Curvature * way.LengthSquared) - (2.0 * arc.StartTangent.Cross(way))) / 2.5;
    }

    private static double Overshoot(BezierSpan piece, in TangentArc arc)
    {
        var most = 0.0;
        for (var i = 0; i <= piece.Degree; i++)
        {
            var place = piece.Control(i);
            most = Math.Max(most, Math.Max(-(place - arc.Start).Dot(arc.StartTangent), (place - arc.End).Dot(arc.EndTangent)));
        }

        return most;
    }
}
