namespace Engraver.Core.Reshaping;

/// <summary>The places of an ellipse or spline at which a function of its parameter is zero: it is evaluated in steps, and intervals with a change of sign are
/// halved down to rounding. A zero without a change of sign between two steps is not found.</summary>
internal static class CurveRoots
{
    private const int StepsOfSpan = 64;
    private const int Halvings = 60;

    /// <param name="spans">Number of spans of the curve.</param>
    /// <param name="value">Function of a fraction of the parameter, 0 to 1.</param>
    /// <returns>Fractions, ascending.</returns>
    public static IEnumerable<double> Find(int spans, Func<double, double> value)
    {
        var steps = StepsOfSpan * spans;
        var before = value(0.0);
        if (before == 0.0) yield return 0.0;
        for (var step = 1; step <= steps; step++)
        {
            var (from, to) = ((step - 1.0) / steps, (double)step / steps);
            var after = value(to);
            if (after == 0.0) yield return to;
            else if (before * after < 0.0) yield return Halved(value, from, to, before);
            before = after;
        }
    }

    private static double Halved(Func<double, double> value, double from, double to, double atFrom)
    {
        for (var i = 0; i < Halvings; i++)
        {
            var middle = (from + to) / 2.0;
            if (value(middle) * atFrom > 0.0) from = middle;
            else to = middle;
        }

        return (from + to) / 2.0;
    }
}
