using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Geometry;
using Engraver.Workbench.Commands.Settings;

namespace Engraver.App.StatusBar;

/// <summary>The line at the bottom: coordinates, drafting switches, the settings that determine accuracy, profile and link.</summary>
public sealed class StatusBarModel : Observable
{
    private readonly DesktopModel _desk;
    private readonly LongWork _work;
    private string _coordinates = "";
    private Point2D _place;

    public StatusBarModel(DesktopModel desk)
    {
        _desk = desk;
        Switches = StatusSwitch.All(desk);
        _work = new LongWork(desk, Look);
        desk.Notifications.Changed += Look;
        Point(Point2D.Origin);
    }

    public IReadOnlyList<StatusSwitch> Switches { get; }

    public string Coordinates
    {
        get => _coordinates;
        private set => Set(ref _coordinates, value);
    }

    /// <summary>The long operation, its progress, and how it is ended; empty for none.</summary>
    public string Progress => _work.Text;

    public bool IsWorking => _work.IsShown;

    /// <summary>The progress is unknown.</summary>
    public bool IsEndless => _work.Fraction is null;

    public double Fraction => _work.Fraction ?? 0.0;

    /// <summary>Of the drawing, and so of the coordinates; tolerances are always in millimetres.</summary>
    public string Unit => Text.Get("Status.Unit", _desk.Session.Document.Current.Drawing?.Unit.Name ?? Text.Get("Status.Millimetres"));

    public string JoinTolerance => Text.Get("Status.Join", _desk.Session.Document.Current.Settings.JoinToleranceMm);

    public string MaxError => Text.Get("Status.MaxCurveError", _desk.Session.Document.Current.Settings.MaxErrorMm);

    public string Profile => _desk.Session.Settings.Current.LastProfile is { } file ? Path.GetFileNameWithoutExtension(file) : Text.Get("Status.DefaultProfile");

    public string Link => _desk.Session.Machine.Connection.Description ?? Text.Get("Status.NotConnected");

    /// <summary>The cursor has moved to a point of the drawing.</summary>
    public void Point(Point2D place)
    {
        var figures = _desk.Session.Settings.Current.Figures();
        (_place, Coordinates) = (place, $"{figures.MovingLength(place.X)}, {figures.MovingLength(place.Y)}");
    }

    private void Look()
    {
        Point(_place);
        _work.Look();
        Tell(nameof(IsWorking));
        Tell(nameof(IsEndless));
        Tell(nameof(Progress));
        Tell(nameof(Fraction));
        Tell(nameof(Unit));
        Tell(nameof(JoinTolerance));
        Tell(nameof(MaxError));
        Tell(nameof(Profile));
        Tell(nameof(Link));
        foreach (var toggle in Switches) toggle.Look();
    }
}
