using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Plots;

namespace Engraver.App.Plots;

/// <summary>The switch of one plot.</summary>
public sealed class PlotToggle(PlotPanel panel, DesktopModel desk, PlotsModel owner) : ObservableObject
{
    public string Name { get; } = Text.Get("PlotName." + panel.Key);

    /// <summary>What it shows, or why it is empty.</summary>
    public string Tip
    {
        get
        {
            var title = Text.Get("PlotTitle." + panel.Key);
            return HasData ? title : Text.Get("Plots.TipNoData", title);
        }
    }

    public bool HasData => owner.Content.Series.Any(series => panel.Quantities.Any(quantity => series.Motion.Of(quantity) is not null));

    /// <summary>The operator has chosen the plot.</summary>
    public bool IsChosen
    {
        get => desk.Session.Settings.Current.ChosenPlots().Contains(panel);
        set
        {
            if (value == IsChosen) return;
            desk.Session.Settings.Change(settings => settings.WithPlot(panel, value));
            owner.Refresh();
        }
    }

    internal void Refresh() => OnPropertyChanged(null);
}
