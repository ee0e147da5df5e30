using Avalonia.Controls;
using Avalonia.Media;
using Avalonia.Styling;
using Engraver.Workbench.Plots;

namespace Engraver.App.Plots;

/// <summary>Colours of plots.</summary>
/// <param name="Background">Behind axes and titles.</param>
/// <param name="Field">Behind the curves.</param>
/// <param name="Text">Titles, numbers and axes.</param>
/// <param name="Grid">Grid lines.</param>
/// <param name="Limit">Limits.</param>
/// <param name="Series">For each role in its order: the first and the second curve of a plot.</param>
internal sealed record PlotColours(Color Background, Color Field, Color Text, Color Grid, Color Limit, IReadOnlyList<(Color First, Color Second)> Series)
{
    /// <summary>Colours of a theme.</summary>
    public static PlotColours Of(IResourceHost resources, ThemeVariant theme)
    {
        return new(
            Find("PanelBrush"), Find("FieldBrush"), Find("QuietTextBrush"), Find("PlotGridBrush"), Find("PlotLimitBrush"),
            [(Find("PlotPlanBrush"), Find("PlotPlanSecondBrush")), (Find("PlotRunBrush"), Find("PlotRunSecondBrush")), (Find("PlotComparedBrush"), Find("PlotComparedSecondBrush"))]);

        Color Find(string key) => resources.TryFindResource(key, theme, out var found) && found is ISolidColorBrush brush ? brush.Color : Colors.Magenta;
    }

    /// <param name="curve">Index of the quantity in its plot.</param>
    public Color Of(PlotRole role, int curve) => curve == 0 ? Series[(int)role].First : Series[(int)role].Second;
}
