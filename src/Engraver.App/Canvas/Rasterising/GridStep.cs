namespace Engraver.App.Canvas.Rasterising;

/// <summary>Distance of the grid lines at a scale: 1, 2 or 5 times a power of ten, at least <see cref="MinPixels"/>.</summary>
/// <param name="Minor">Drawing units.</param>
/// <param name="MinorPerMajor">Every line of this number is a major line.</param>
internal readonly record struct GridStep(double Minor, int MinorPerMajor)
{
    public const double MinPixels = 10.0;

    public static GridStep For(double unitsPerPixel) => AtLeast(unitsPerPixel * MinPixels);

    /// <summary>The smallest step of at least a distance.</summary>
    /// <param name="least">Positive.</param>
    public static GridStep AtLeast(double least)
    {
        var decade = Math.Pow(10.0, Math.Floor(Math.Log10(least)));
        foreach (var (factor, major) in (ReadOnlySpan<(double, int)>)[(1.0, 10), (2.0, 5), (5.0, 10), (10.0, 10), (20.0, 5)])
        {
            if (factor * decade >= least) return new GridStep(factor * decade, major);
        }

        return new GridStep(50.0 * decade, 10);
    }
}
