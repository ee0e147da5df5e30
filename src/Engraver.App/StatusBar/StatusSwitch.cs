using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Workbench.Views;

namespace Engraver.App.StatusBar;

/// <summary>One drafting switch; a click runs its command.</summary>
/// <param name="name">The displayed name.</param>
/// <param name="command">The command that switches it.</param>
public sealed class StatusSwitch(string name, string command, Func<ViewState, bool> isOn, DesktopModel desk) : ObservableObject
{
    public string Name => name;

    public string Command => command;

    /// <summary>Its function, with its key.</summary>
    public string Tip => Text.Get("Switch." + name);

    public bool IsOn => isOn(desk.Session.View.Current);

    public RelayCommand Switch { get; } = new(() => _ = desk.Queue.RunAsync(command, isOn(desk.Session.View.Current) ? "OFF" : "ON"));

    /// <summary>The switches of the status bar, with AutoCAD's names.</summary>
    public static IReadOnlyList<StatusSwitch> All(DesktopModel desk) =>
    [
        new("SNAP", "SNAP", view => view.Snap, desk),
        new("GRID", "GRID", view => view.Grid, desk),
        new("ORTHO", "ORTHO", view => view.Ortho, desk),
        new("POLAR", "POLAR", view => view.Polar, desk),
        new("OSNAP", "OSNAP", view => view.ObjectSnap, desk),
        new("DYN", "DYNAMICINPUT", view => view.DynamicInput, desk),
    ];

    public void Refresh() => OnPropertyChanged(nameof(IsOn));
}
