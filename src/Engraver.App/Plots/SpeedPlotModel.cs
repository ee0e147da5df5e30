using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Workbench.Playback;

namespace Engraver.App.Plots;

/// <summary>Planned speed over time, with the position of the playback.</summary>
public sealed class SpeedPlotModel : ObservableObject, IVisibilityAware
{
    private bool _isPageVisible;
    private readonly DesktopModel _desk;
    private PlannedMotion? _shown;

    public SpeedPlotModel(DesktopModel desk)
    {
        _desk = desk;
        desk.Notifications.Changed += Refresh;
        desk.Derived.ToolMoved += () => OnPropertyChanged(nameof(At));
        Refresh();
    }

    public SpeedCurve? Curve { get; private set; }

    public bool IsEmpty => Curve is null;

    /// <summary>Seconds; setting it moves the playback.</summary>
    public double At
    {
        get => _desk.Derived.AtSeconds;
        set => _desk.Derived.MoveTo(value);
    }

    public bool IsPageVisible
    {
        get => _isPageVisible;
        set
        {
            if (SetProperty(ref _isPageVisible, value) && value) Refresh();
        }
    }

    private void Refresh()
    {
        if (ReferenceEquals(_desk.Derived.Current.Motion, _shown) || (!IsPageVisible && _shown is null)) return;
        _shown = IsPageVisible ? _desk.Derived.Current.Motion : null; // a hidden page keeps no reference to an old plan
        Curve = _shown is null ? null : SpeedCurve.From(_shown);
        OnPropertyChanged(null);
    }
}
