namespace Engraver.Core.Geometry;

/// <summary>Lengths of curves by adaptive Gauss quadrature of their speed: a part is halved until the sum of its halves agrees with the whole to a relative
/// 1e-12.</summary>
public static class ArcLength
{
    private const double RelativeTolerance = 1e-12;

    /// <summary>Deepest halving. At a cusp (speed zero inside the span) each level halves the error, so forty levels reduce it below the rounding of any
    /// drawing.</summary>
    private const int MaxHalvings = 40;

    /// <summary>Maximum number of halvings of one span in total, for the case that rounding prevents the halves from agreeing.</summary>
    private const int MaxParts = 20_000;

    /// <summary>Positive half of the ten Gauss-Legendre nodes on [-1, 1].</summary>
    private static readonly double[] Nodes = [0.14887433898163122, 0.43339539412924719, 0.67940956829902441, 0.86506336668898451, 0.97390652851717172];

    private static readonly double[] Weights = [0.29552422471475287, 0.26926671930999636, 0.21908636251598204, 0.14945134915058059, 0.06667134430868814];

    /// <summary>Length in space or, <paramref name="inPlan"/>, of the projection to the XY plane.</summary>
    public static double Measure(BezierSpan span, bool inPlan)
    {
        var local = FromItsStart(span);
        return Measure(parameter => Speed(local, inPlan, parameter), 0.0, 1.0);
    }

    /// <summary>Length between two parameters of a curve whose speed is known.</summary>
    /// <param name="speed">Length of the derivative at a parameter.</param>
    public static double Measure(Func<double, double> speed, double from, double to)
    {
        ArgumentNullException.ThrowIfNull(speed);
        var whole = Gauss(speed, from, to);
        var parts = MaxParts;
        return Refined(speed, from, to, whole, RelativeTolerance * whole, MaxHalvings, ref parts);
    }

    /// <summary>The span moved so that it starts at the origin: rounding of large coordinates would disturb the speed of a very short span, as between two
    /// knots 1e-8 apart.</summary>
    private static BezierSpan FromItsStart(BezierSpan span)
    {
        var points = span.Homogeneous.ToArray();
        var (x, y, z) = (span.Start.X, span.Start.Y, span.Z(0));
        for (var i = 0; i < points.Length; i += BezierSpan.Stride)
        {
            var weight = points[i + 3];
            (points[i], points[i + 1], points[i + 2]) = (points[i] - (x * weight), points[i + 1] - (y * weight), points[i + 2] - (z * weight));
        }

        return new BezierSpan(points);
    }

    private static double Refined(Func<double, double> speed, double from, double to, double whole, double tolerance, int halvings, ref int parts)
    {
        var middle = (from + to) / 2.0;
        var first = Gauss(speed, from, middle);
        var second = Gauss(speed, middle, to);
        if (!(Math.Abs(first + second - whole) > tolerance) || halvings == 0 || --parts < 0) return first + second;
        return Refined(speed, from, middle, first, tolerance, halvings - 1, ref parts) + Refined(speed, middle, to, second, tolerance, halvings - 1, ref parts);
    }

    private static double Gauss(Func<double, double> speed, double from, double to)
    {
        var (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
        var sum = 0.0;
        for (var i = 0; i < Nodes.Length; i++)
        {
            sum += Weights[i] * (speed(middle - (half * Nodes[i])) + speed(middle + (half * Nodes[i])));
        }

        return sum * half;
    }

    private static double Speed(BezierSpan span, bool inPlan, double parameter)
    {
        span.EvaluateInSpace(parameter, out var derivative);
        return inPlan ? double.Hypot(derivative.X, derivative.Y) : derivative.Length;
    }
}
