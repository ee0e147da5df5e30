using Engraver.App.Canvas.Rasterising;
using Engraver.App.Texts;
using ScottPlot;
using SkiaSharp;

namespace Engraver.App.Plots;

/// <summary>Ticks of a time axis at round seconds, minutes and hours.</summary>
internal sealed class TimeTicks : ITickGenerator
{
    private const double MinPixels = 70.0;

    private static readonly double[] s_steps = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 36000];

    public Tick[] Ticks { get; set; } = [];

    public int MaxTickCount { get; set; } = 100;

    public void Regenerate(CoordinateRange range, Edge edge, PixelLength size, Paint paint, LabelStyle labelStyle)
    {
        if (!(range.Span > 0.0) || !double.IsFinite(range.Span) || size.Length <= 0.0f)
        {
            Ticks = [];
            return;
        }

        var least = range.Span * MinPixels * Math.Max(labelStyle.FontSize / PlotPicture.FontSize, 1.0) / size.Length;
        var step = Step(least);
        var first = Math.Ceiling((range.Min / step) - 1e-9);
        var count = Math.Clamp((int)Math.Floor((range.Max / step) - first + 1e-9) + 1, 0, MaxTickCount);
        Ticks = [.. Enumerable.Range(0, count).Select(i => (first + i) * step).Select(at => new Tick(at, LabelOf(at, step)))];
    }

    /// <summary>Time between two ticks, seconds: a usual one of at least this length.</summary>
    internal static double Step(double least) => least < 1.0 ? GridStep.AtLeast(least).Minor : s_steps.FirstOrDefault(step => step >= least, GridStep.AtLeast(least).Minor);

    /// <summary>Clock time with as many decimals as the step needs.</summary>
    internal static string LabelOf(double seconds, double step) => ClockText.Format(seconds, step < 1.0 ? (int)Math.Ceiling(-Math.Log10(step) - 1e-9) : 0);
}
