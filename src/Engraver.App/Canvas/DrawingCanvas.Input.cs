using Avalonia;
using Avalonia.Input;
using Engraver.App.Canvas.Interaction;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Views;

namespace Engraver.App.Canvas;

/// <summary>Mouse and keys: from events to intents, and from intents to the view and the commands.</summary>
public sealed partial class DrawingCanvas
{
    private const double FindingReach = 9.0;
    private const double FindingZoom = 8.0;

    /// <summary>60, the first value of ZOOMFACTOR, zooms by a quarter a notch.</summary>
    private const double ZoomFactorOfAQuarter = 240.0;

    private readonly PointerMachine _pointer = new();

    /// <summary>Half the side of the pickbox, in units of the control (PICKBOX).</summary>
    public double PickBox { get; set; } = 4.0;

    /// <summary>How far one step of the wheel zooms, 3 to 100 (ZOOMFACTOR).</summary>
    public double ZoomFactor { get; set; } = 60.0;

    /// <summary>The wheel turned forward zooms out (ZOOMWHEEL).</summary>
    public bool ReversesWheel { get; set; }

    /// <summary>Length of the crosshair in percent of the canvas (CURSORSIZE).</summary>
    public double CursorSize
    {
        get => _cursor.CursorSize;
        set => _cursor.CursorSize = value;
    }

    protected override void OnPointerPressed(PointerPressedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerPressed(e);
        Focus();
        if (ButtonOf(e.GetCurrentPoint(this).Properties.PointerUpdateKind) is not { } button) return;
        e.Pointer.Capture(this);
        LookWhatIsAsked();
        if (_aim is null) LetGo();
        var at = PlaceOf(e);
        Do(_pointer.Press(at, button, e.KeyModifiers.HasFlag(KeyModifiers.Shift), e.ClickCount, () => EntityAt(at) is not null, () => GripAt(at) is not null));
        e.Handled = true;
    }

    protected override void OnPointerMoved(PointerEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerMoved(e);
        var at = PlaceOf(e);
        _cursor.Place = new Point(at.X, at.Y);
        Do(_pointer.Move(at));
    }

    protected override void OnPointerReleased(PointerReleasedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerReleased(e);
        LookWhatIsAsked();
        if (ButtonOf(e.GetCurrentPoint(this).Properties.PointerUpdateKind) is { } button) Do(_pointer.Release(PlaceOf(e), button));
        e.Pointer.Capture(null);
    }

    protected override void OnPointerWheelChanged(PointerWheelEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerWheelChanged(e);
        _pointer.NotchFactor = 1.0 + (ZoomFactor / ZoomFactorOfAQuarter);
        Do(_pointer.Wheel(PlaceOf(e), ReversesWheel ? -e.Delta.Y : e.Delta.Y));
        e.Handled = true;
    }

    protected override void OnPointerExited(PointerEventArgs e)
    {
        base.OnPointerExited(e);
        (_cursor.Place, _cursor.Snap, _signs.Hovered, _signs.HoveredGrip) = (null, null, null, null);
        UpdateSigns();
        ShowCursor();
        Commands?.CursorAt(null);
    }

    protected override void OnPointerCaptureLost(PointerCaptureLostEventArgs e)
    {
        base.OnPointerCaptureLost(e);
        if (_pointer.IsPanning) _pointer.Lost();
    }

    /// <summary>Esc, wherever the focus is: the shell calls it after the machine has had its turn.</summary>
    public void Escape() => Do(_pointer.Escape());

    private static PointerButton? ButtonOf(PointerUpdateKind kind) => kind switch
    {
        PointerUpdateKind.LeftButtonPressed or PointerUpdateKind.LeftButtonReleased => PointerButton.Left,
        PointerUpdateKind.MiddleButtonPressed or PointerUpdateKind.MiddleButtonReleased => PointerButton.Middle,
        PointerUpdateKind.RightButtonPressed or PointerUpdateKind.RightButtonReleased => PointerButton.Right,
        _ => null,
    };

    private Point2D PlaceOf(PointerEventArgs e)
    {
        var at = e.GetPosition(this);
        return new Point2D(at.X, at.Y);
    }

    private void Do(CanvasIntent intent)
    {
        switch (intent)
        {
            case CanvasIntent.Pan pan:
                View?.PanBy(new Vector2D(pan.By.X * UnitsPerPoint, -pan.By.Y * UnitsPerPoint));
                break;
            case CanvasIntent.Zoom zoom:
                View?.ZoomAbout(ToDrawing(zoom.About), zoom.Factor);
                break;
            case CanvasIntent.Hover hover:
                Hover(hover.At);
                break;
            case CanvasIntent.Select select:
                Commands?.SelectBox(ToDrawing(select.Box.From), ToDrawing(select.Box.To), select.Box.IsCrossing, select.Remove);
                break;
            case CanvasIntent.Open open:
                ShowFinding(open.At);
                break;
            default:
                Command(intent);
                break;
        }

        ShowCursor();
    }

    private void Command(CanvasIntent intent)
    {
        if (Commands is not { } commands) return;
        if (intent is CanvasIntent.ZoomExtents) commands.ZoomExtents();
        else if (intent is CanvasIntent.Cancel) commands.Cancel();
        else if (intent is CanvasIntent.Menu menu) commands.Menu(ToDrawing(menu.At));
        else if (intent is CanvasIntent.GivePoint given) Give(commands, given);
        else if (intent is CanvasIntent.HoldGrip hold && GripAt(hold.At) is { } grip) Hold(commands, grip.Place);
        else if (intent is CanvasIntent.DropGrip drop) commands.GripDropped(Aimed(drop.At));
        else if (intent is CanvasIntent.Pick pick && EntityAt(pick.At) is { } entity) commands.PickAt(ToDrawing(pick.At), entity, Scene!.Drawing, pick.Remove);
    }

    private void Hold(ICanvasCommands commands, Point2D grip)
    {
        _held = grip;
        UpdateSigns();
        commands.GripHeld(grip);
    }

    private void Give(ICanvasCommands commands, CanvasIntent.GivePoint given)
    {
        if (_aim is not { Use: PointUse.Place } || !WaitsForSnap(given.At)) commands.PointGiven(Aimed(given.At), given.Remove);
    }

    /// <summary>Brings the finding under the cursor into the middle, nearer by <see cref="FindingZoom"/>.</summary>
    private void ShowFinding(Point2D at)
    {
        var place = ToDrawing(at);
        if (View is not { } view || !view.Current.Shown.HasFlag(CanvasLayers.Findings)) return;
        if (Overlay?.FindingNear(place, FindingReach * UnitsPerPoint) is { } finding) view.FocusOn(new ViewFocus(finding, null), view.Current.Height / FindingZoom);
    }
}
