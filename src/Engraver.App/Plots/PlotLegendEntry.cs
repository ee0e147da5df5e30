using Engraver.App.Texts;
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
        var hasAxes = content.Panels.Any(panel => panel.Quantities.Count > 1);
        return [.. content.Series.SelectMany(series => hasAxes ? (IEnumerable<PlotLegendEntry>)[OfAxis(series, "X", ""), OfAxis(series, "Y", "Second")] : [new PlotLegendEntry(PlotPicture.MotionName(series), BrushOf(series, ""))])];
    }

    private static PlotLegendEntry OfAxis(PlotSeries series, string axis, string curve) => new(Text.Get("Plots.CurveOfAxis", PlotPicture.MotionName(series), axis), BrushOf(series, curve));

    private static string BrushOf(PlotSeries series, string curve) => $"Plot{series.Role}{curve}Brush";
}
