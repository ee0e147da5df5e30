using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>Tolerances of chords along an arc, mm.</summary>
/// <param name="MaxError">Largest distance between them, in both directions.</param>
/// <param name="Rounding">Rounding error of the coordinates, from their number of decimals; the direction of a short chord varies by it.</param>
internal readonly record struct ChordTolerances(double MaxError, double Rounding)
{
    private const double FinestRounding = 2e-6;
    private const int MaxDecimals = 5;

    /// <summary>The tolerances with the rounding of these vertices: that of the fewest decimals (3 to 5) that represent them all.</summary>
    public static ChordTolerances For(ReadOnlySpan<Point2D> vertices, double maxError)
    {
        for (var decimals = 3; decimals <= MaxDecimals; decimals++)
        {
            var step = Math.Pow(10.0, -decimals);
            if (AreMultiples(vertices, 1.0 / step)) return new ChordTolerances(maxError, step);
        }

        return new ChordTolerances(maxError, FinestRounding);
    }

    private static bool AreMultiples(ReadOnlySpan<Point2D> vertices, double perUnit)
    {
        foreach (var vertex in vertices)
        {
            if (!IsWhole(vertex.X * perUnit) || !IsWhole(vertex.Y * perUnit)) return false;
        }

        return true;
    }

    private static bool IsWhole(double value) => Math.Abs(value - Math.Round(value)) <= 1e-4;
}
