namespace Engraver.Core.Geometry;

/// <summary>A non-uniform rational B-spline as stored: degree, knots and control points. Its domain is knot[degree] to knot[count]; knots outside only shape
/// the ends.</summary>
public sealed class NurbsCurve
{
    /// <summary>A knot lower than the one before it by no more than this part of the whole range was rounded, and is taken as equal.</summary>
    private const double KnotRounding = 1e-9;

    private readonly double[] _knots;
    private readonly double[] _points;

    /// <param name="degree">1 to <see cref="LargestDegree"/>.</param>
    /// <param name="knots">Knots for which <see cref="AreUsable"/> holds.</param>
    /// <param name="homogeneous">x w, y w, z w, w for each control point, weights positive.</param>
    public NurbsCurve(int degree, double[] knots, double[] homogeneous)
    {
        if (!AreUsable(knots, degree, homogeneous.Length / BezierSpan.Stride)) throw new ArgumentException("Knots, degree and control points do not fit together.", nameof(knots));
        Degree = degree;
        _knots = Levelled(knots);
        _points = homogeneous;
    }

    /// <summary>Largest degree that is accepted: beyond it binomial coefficients lose too many digits; CAD programs stop at 25 or earlier.</summary>
    public static int LargestDegree => 25;

    public int Degree { get; }

    public int PointCount => _points.Length / BezierSpan.Stride;

    /// <summary>True for points + degree + 1 knots that do not decrease (except by rounding) and whose domain has a length.</summary>
    public static bool AreUsable(ReadOnlySpan<double> knots, int degree, int points)
    {
        if (degree < 1 || degree > LargestDegree || points <= degree || knots.Length != points + degree + 1) return false;
        var (highest, slack) = (knots[0], KnotRounding * (knots[^1] - knots[0]));
        foreach (var knot in knots)
        {
            if (!(knot >= highest - slack)) return false;
            highest = Math.Max(highest, knot);
        }

        return knots[degree] < knots[points] && double.IsFinite(knots[^1] - knots[0]);
    }

    /// <summary>Raises each knot to the highest before it.</summary>
    private static double[] Levelled(double[] knots)
    {
        var level = (double[])knots.Clone();
        for (var i = 1; i < level.Length; i++) level[i] = Math.Max(level[i], level[i - 1]);
        return level;
    }

    /// <summary>Substitutes for unusable knots: uniform, with the curve beginning and ending at its outer control points.</summary>
    public static double[] UniformKnots(int degree, int points)
    {
        var knots = new double[points + degree + 1];
        for (var i = 0; i < knots.Length; i++) knots[i] = Math.Clamp(i - degree, 0, points - degree);
        return knots;
    }

    /// <summary>The same curve as Bezier spans, one for each knot interval with a length; spans that are a point are left out. Null when none is
    /// left.</summary>
    public RationalCurve? ToCurve()
    {
        var spans = new List<BezierSpan>(PointCount - Degree);
        for (var i = Degree; i < PointCount; i++)
        {
            if (!(_knots[i] < _knots[i + 1])) continue;
            var span = new BezierSpan(SpanAt(i));
            if (!span.IsPoint) spans.Add(span);
        }

        return spans.Count == 0 ? null : new RationalCurve(SegmentKind.Spline, Closed(spans));
    }

    /// <summary>Exactly closes a curve whose ends differ only by rounding.</summary>
    private static BezierSpan[] Closed(List<BezierSpan> spans)
    {
        const double Rounding = 1e-12;
        BezierSpan[] result = [.. spans];
        var (start, hull) = (result[0].Start, CurveBounds.Hull(result[0]));
        var size = hull.Width + hull.Height + Math.Abs(start.X) + Math.Abs(start.Y);
        if (start.IsNear(result[^1].End, Rounding * size)) RationalCurve.CloseExactly(result);
        return result;
    }

    /// <summary>Control points of the interval from knot i to the next: the knots a = u(i) and b = u(i+1) are inserted until each occurs degree times (blossoms
    /// f(a.., b..)).</summary>
    private double[] SpanAt(int i)
    {
        var (p, a, b) = (Degree, _knots[i], _knots[i + 1]);
        var work = _points.AsSpan((i - p) * BezierSpan.Stride, (p + 1) * BezierSpan.Stride).ToArray();
        var tail = new double[work.Length];
        work.AsSpan(p * BezierSpan.Stride).CopyTo(tail.AsSpan(p * BezierSpan.Stride));
        for (var level = 1; level <= p; level++)
        {
            for (var j = i; j > i - p + level - 1; j--)
            {
                var (low, high) = (_knots[j], _knots[j + p - level + 1]);
                Interpolate(work, j - i + p - 1, j - i + p, (high - a) / (high - low), j - i + p);
            }

            work.AsSpan(p * BezierSpan.Stride).CopyTo(tail.AsSpan((p - level) * BezierSpan.Stride));
        }

        return Forward(tail, i, a, b);
    }

    /// <summary>From the blossoms f(a.., u(i+1) .. u(i+m)), m = 0 .. degree, to f(a.., b..). <paramref name="tail"/> holds them with m decreasing.</summary>
    private double[] Forward(double[] tail, int i, double a, double b)
    {
        var p = Degree;
        var points = tail;
        var span = new double[tail.Length];
        for (var level = 0; level <= p; level++)
        {
            points.AsSpan(0, BezierSpan.Stride).CopyTo(span.AsSpan(level * BezierSpan.Stride));
            for (var m = 0; m < p - level; m++)
            {
                var high = _knots[i + m + 1];
                Interpolate(points, m, m + 1, (high - b) / (high - a), m);
            }
        }

        return span;
    }

    private static void Interpolate(double[] points, int first, int second, double share, int into)
    {
        for (var axis = 0; axis < BezierSpan.Stride; axis++)
        {
            var (low, high) = (points[(first * BezierSpan.Stride) + axis], points[(second * BezierSpan.Stride) + axis]);
            points[(into * BezierSpan.Stride) + axis] = share == 0.0 ? high : share == 1.0 ? low : high + (share * (low - high));
        }
    }
}
