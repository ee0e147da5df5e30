using Engraver.App.Canvas.Rasterising;

namespace Engraver.App.Plots;

/// <summary>Positions of the grid lines of a chart: at round numbers, with room for the labels.</summary>
internal static class ChartTicks
{
    private const double MinRowPixels = 40.0;
    private const double MinColumnPixels = 60.0;

    private static readonly double[] s_clockSteps = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 36000];

    /// <summary>Speeds from zero to the first one at or above the peak: the last is the top of the chart.</summary>
    /// <param name="peak">Positive.</param>
    /// <param name="pixels">Height of the chart.</param>
    public static IReadOnlyList<double> Speeds(double peak, double pixels)
    {
        var step = GridStep.AtLeast(peak * MinRowPixels / Math.Max(pixels, MinRowPixels)).Minor;
        var rows = Math.Max(1, (int)Math.Ceiling((peak / step) - 1e-9));
        return [.. Enumerable.Range(0, rows + 1).Select(row => row * step)];
    }

    /// <summary>Seconds from zero up to the end, in steps that are usual for time.</summary>
    /// <param name="total">Seconds; positive.</param>
    /// <param name="pixels">Width of the chart.</param>
    public static IReadOnlyList<double> Seconds(double total, double pixels)
    {
        var least = total * MinColumnPixels / Math.Max(pixels, MinColumnPixels);
        var step = s_clockSteps.FirstOrDefault(step => step >= least, GridStep.AtLeast(least).Minor);
        return [.. Enumerable.Range(0, (int)Math.Floor((total / step) + 1e-9) + 1).Select(column => column * step)];
    }
}
