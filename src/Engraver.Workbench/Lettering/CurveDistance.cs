using Engraver.Core.Geometry;

namespace Engraver.Workbench.Lettering;

/// <summary>The distance of a point from a curve that is only known by its points: the nearest of several points, and a ternary search beside it.</summary>
internal static class CurveDistance
{
    private const int Points = 32;
    private const int Steps = 40;

    /// <param name="curve">A point by its fraction, 0 to 1.</param>
    public static double Of(Vector3D place, Func<double, Vector3D> curve)
    {
        var nearest = Enumerable.Range(0, Points + 1).MinBy(i => At((double)i / Points));
        // Not beyond the ends: there the distance would not change, and the search would leave the minimum.
        var (from, to) = (Math.Max(0.0, (nearest - 1.0) / Points), Math.Min(1.0, (nearest + 1.0) / Points));
        for (var step = 0; step < Steps; step++)
        {
            var (one, other) = (from + ((to - from) / 3.0), to - ((to - from) / 3.0));
            if (At(one) < At(other)) to = other;
            else from = one;
        }

        return At(0.5 * (from + to));

        double At(double fraction) => (curve(fraction) - place).Length;
    }
}
