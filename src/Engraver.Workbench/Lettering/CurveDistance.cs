using Engraver.Core.Geometry;

namespace Engraver.Workbench.Lettering;

/// <summary>The distance of a point from a curve that is only known by its points: a ternary search beside each of several points that is nearer than the
/// points before and after it. A curve that turns back on itself between two points needs more of them.</summary>
internal static class CurveDistance
{
    /// <summary>Enough for a curve without turns.</summary>
    public const int FewPoints = 32;

    public const int ManyPoints = 4096;

    private const int Steps = 40;

    /// <param name="curve">A point by its fraction, 0 to 1.</param>
    /// <param name="points">Number of steps between the points that are tried first.</param>
    public static double Of(Vector3D place, Func<double, Vector3D> curve, int points)
    {
        var distances = new double[points + 1];
        for (var i = 0; i <= points; i++) distances[i] = Distance((double)i / points);
        var least = double.PositiveInfinity;
        for (var i = 0; i <= points; i++)
        {
            // Not beyond the ends: there the distance would not change, and the search would leave the minimum.
            var (before, after) = (Math.Max(0, i - 1), Math.Min(points, i + 1));
            if (distances[i] <= distances[before] && distances[i] <= distances[after]) least = Math.Min(least, Search((double)before / points, (double)after / points));
        }

        return least;

        double Search(double from, double to)
        {
            for (var step = 0; step < Steps; step++)
            {
                var (one, other) = (from + ((to - from) / 3.0), to - ((to - from) / 3.0));
                if (Distance(one) < Distance(other)) to = other;
                else from = one;
            }

            return Distance(0.5 * (from + to));
        }

        double Distance(double fraction) => (curve(fraction) - place).Length;
    }
}
