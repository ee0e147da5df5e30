using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Workbench.Playback;

namespace Engraver.App.Plots;

/// <summary>Planned speed over time, with the tool's place in it.</summary>
public sealed class PlotModel : Observable
{
    private readonly DesktopModel _desk;
    private PlannedMotion? _shown;

    public PlotModel(DesktopModel desk)
    {
        _desk = desk;
        desk.Changed += Look;
        desk.Derived.Moved += () => Tell(nameof(At));
        Look();
    }

    public SpeedCurve? Curve { get; private set; }

    public bool IsEmpty => Curve is null;

    /// <summary>Seconds; moving it moves the tool.</summary>
    public double At
    {
        get => _desk.Derived.AtSeconds;
        set => _desk.Derived.MoveTo(value);
    }

    private void Look()
    {
        if (ReferenceEquals(_desk.Derived.Current.Motion, _shown)) return;
        _shown = _desk.Derived.Current.Motion;
        Curve = _shown is null ? null : SpeedCurve.From(_shown);
        Tell(null);
    }
}
