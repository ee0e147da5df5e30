using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Workbench.Playback;

namespace Engraver.App.Plots;

/// <summary>Planned speed over time, with the position of the playback.</summary>
public sealed class PlotModel : Observable, ISeen
{
    private bool _isSeen;
    private readonly DesktopModel _desk;
    private PlannedMotion? _shown;

    public PlotModel(DesktopModel desk)
    {
        _desk = desk;
        desk.Notifications.Changed += Look;
        desk.Derived.Moved += () => Tell(nameof(At));
        Look();
    }

    public SpeedCurve? Curve { get; private set; }

    public bool IsEmpty => Curve is null;

    /// <summary>Seconds; setting it moves the playback.</summary>
    public double At
    {
        get => _desk.Derived.AtSeconds;
        set => _desk.Derived.MoveTo(value);
    }

    public bool IsSeen
    {
        get => _isSeen;
        set
        {
            if (Set(ref _isSeen, value) && value) Look();
        }
    }

    private void Look()
    {
        if (ReferenceEquals(_desk.Derived.Current.Motion, _shown) || (!IsSeen && _shown is null)) return;
        _shown = IsSeen ? _desk.Derived.Current.Motion : null; // a hidden page keeps no reference to an old plan
        Curve = _shown is null ? null : SpeedCurve.From(_shown);
        Tell(null);
    }
}
