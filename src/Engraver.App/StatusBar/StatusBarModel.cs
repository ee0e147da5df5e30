using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Geometry;
using Engraver.Workbench.Commands.Settings;

namespace Engraver.App.StatusBar;

/// <summary>The line at the bottom: coordinates, drafting switches, the settings that determine accuracy, profile and link.</summary>
public sealed class StatusBarModel : ObservableObject
{
    private readonly DesktopModel _desk;
    private readonly LongOperation _operation;
    private string _coordinates = "";
    private Point2D _place;

    public StatusBarModel(DesktopModel desk)
    {
        _desk = desk;
        Switches = StatusSwitch.All(desk);
        _operation = new LongOperation(desk, Refresh);
        desk.Notifications.Changed += Refresh;
        SetCursor(Point2D.Origin);
    }

    public IReadOnlyList<StatusSwitch> Switches { get; }

    public string Coordinates
    {
        get => _coordinates;
        private set => SetProperty(ref _coordinates, value);
    }

    /// <summary>The long operation, its progress, and how it is ended; empty for none.</summary>
    public string Progress => _operation.Text;

    public bool IsWorking => _operation.IsShown;

    /// <summary>The progress is unknown.</summary>
    public bool IsIndeterminate => _operation.Fraction is null;

    public double Fraction => _operation.Fraction ?? 0.0;

    /// <summary>Of the drawing, and so of the coordinates; tolerances are always in millimetres.</summary>
    public string Unit => Text.Get("Status.Unit", _desk.Session.Document.Current.Drawing?.Unit.Name ?? Text.Get("Status.Millimetres"));

    public string JoinTolerance => Text.Get("Status.Join", _desk.Session.Document.Current.Settings.JoinToleranceMm);

    public string MaxError => Text.Get("Status.MaxCurveError", _desk.Session.Document.Current.Settings.MaxErrorMm);

    public string Profile => _desk.Session.Settings.Current.LastProfile is { } file ? Path.GetFileNameWithoutExtension(file) : Text.Get("Status.DefaultProfile");

    public string Link => _desk.Session.Machine.Connection.Description ?? Text.Get("Status.NotConnected");

    /// <summary>The cursor has moved to a point of the drawing.</summary>
    public void SetCursor(Point2D place)
    {
        var figures = _desk.Session.Settings.Current.Figures();
        (_place, Coordinates) = (place, $"{figures.FormatCursorLength(place.X)}, {figures.FormatCursorLength(place.Y)}");
    }

    private void Refresh()
    {
        SetCursor(_place);
        _operation.Refresh();
        OnPropertyChanged(nameof(IsWorking));
        OnPropertyChanged(nameof(IsIndeterminate));
        OnPropertyChanged(nameof(Progress));
        OnPropertyChanged(nameof(Fraction));
        OnPropertyChanged(nameof(Unit));
        OnPropertyChanged(nameof(JoinTolerance));
        OnPropertyChanged(nameof(MaxError));
        OnPropertyChanged(nameof(Profile));
        OnPropertyChanged(nameof(Link));
        foreach (var toggle in Switches) toggle.Refresh();
    }
}
