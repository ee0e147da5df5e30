using Engraver.Workbench.Plots;

namespace Engraver.App.Plots;

/// <summary>A curve in the legend of the page.</summary>
/// <param name="Name">Its motion, with the axis where plots have a curve for each axis.</param>
/// <param name="Brush">Name of the brush of its colour.</param>
public sealed record PlotLegendEntry(string Name, string Brush)
{
    /// <summary>The entries of all curves of a content: two of each motion if a visible plot has a curve for each axis.</summary>
    public static IReadOnlyList<PlotLegendEntry> Of(PlotContent content)
    {
        ArgumentNullException.ThrowIfNull(content);
        if (content.Panels.MaxBy(panel => panel.Quantities.Count) is not { } widest) return [];
        return [.. content.Series.SelectMany(series => Enumerable.Range(0, widest.Quantities.Count).Select(curve => new PlotLegendEntry(PlotPicture.NameOf(series, widest, curve), BrushOf(series, curve))))];
    }

    private static string BrushOf(PlotSeries series, int curve) => curve == 0 ? $"Plot{series.Role}Brush" : $"Plot{series.Role}SecondBrush";
}
