using Engraver.App.Binding;
using Engraver.App.Desk;

namespace Engraver.App.StatusBar;

/// <summary>One drafting switch; a click runs its command.</summary>
public sealed class StatusSwitch(string name, WorkDesk desk) : Observable
{
    public string Name => name;

    public bool IsOn => name switch
    {
        "SNAP" => desk.Session.View.Current.Snap,
        "GRID" => desk.Session.View.Current.Grid,
        "ORTHO" => desk.Session.View.Current.Ortho,
        "OSNAP" => desk.Session.View.Current.ObjectSnap,
        _ => desk.Session.View.Current.DynamicInput,
    };

    public Act Switch { get; } = new(() => _ = desk.SwitchAsync(name));

    public void Look() => Tell(nameof(IsOn));
}
