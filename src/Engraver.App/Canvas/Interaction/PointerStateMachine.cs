using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Interaction;

/// <summary>Converts presses, movements and the wheel to intents, as in AutoCAD: the wheel zooms around the cursor, pressing it pans, double-clicking it
/// shows the whole drawing; a click picks what is under the cursor; a click on empty space starts a box that a second click (or releasing after a drag)
/// ends.</summary>
internal sealed class PointerStateMachine
{
    /// <summary>Pixels that the pointer may move before a press becomes a drag.</summary>
    private const double DragDistance = 4.0;

    private Point2D? _panFrom;
    private Point2D? _boxFrom;
    private Point2D _cursor;
    private bool _boxPressed;
    private bool _boxRemoves;
    private Point2D? _gripFrom;
    private Point2D? _pointFrom;
    private bool _asksForPoint;

    /// <summary>A command requests a point: clicks are points, not picks, and a box that was started is cancelled.</summary>
    public bool AsksForPoint
    {
        get => _asksForPoint;
        set
        {
            _asksForPoint = value;
            if (value) DropBox();
        }
    }

    /// <summary>The requested point is the opposite corner of a box.</summary>
    public bool AsksForCorner { get; set; }

    /// <summary>Zoom factor of one notch of the wheel.</summary>
    public double NotchFactor { get; set; } = 1.25;

    /// <summary>The box while it is drawn.</summary>
    public SelectionBox? Box => _boxFrom is { } from ? new SelectionBox(from, _cursor) : null;

    public bool IsPanning => _panFrom is not null;

    /// <param name="hits">Whether something is under the pickbox; called only when needed.</param>
    /// <param name="clicks">2 for the second click of a double click.</param>
    /// <param name="grips">Whether a grip is at the point; null if no grips are shown.</param>
    public CanvasIntent Press(Point2D at, PointerButton button, bool shift, int clicks, Func<bool> hits, Func<bool>? grips = null)
    {
        _cursor = at;
        if (button == PointerButton.Middle) return PressWheel(at, clicks);
        if (button == PointerButton.Right) return new CanvasIntent.Menu(at);
        if (AsksForPoint)
        {
            _pointFrom = at;
            return new CanvasIntent.SubmitPoint(at, shift);
        }

        if (clicks >= 2) return OpenAt(at);
        if (_boxFrom is not null) return FinishBox(at, _boxRemoves || shift);
        if (!shift && grips is not null && grips())
        {
            _gripFrom = at;
            return new CanvasIntent.GrabGrip(at);
        }

        if (hits()) return new CanvasIntent.Pick(at, shift);
        (_boxFrom, _boxPressed, _boxRemoves) = (at, true, shift);
        return CanvasIntent.None;
    }

    public CanvasIntent Move(Point2D at)
    {
        _cursor = at;
        if (_panFrom is not { } from) return new CanvasIntent.Hover(at);
        _panFrom = at;
        return new CanvasIntent.Pan(at - from);
    }

    public CanvasIntent Release(Point2D at, PointerButton button)
    {
        _cursor = at;
        if (button == PointerButton.Middle) _panFrom = null;
        if (button == PointerButton.Left && EndDrag(at) is { } dropped) return dropped;
        if (button != PointerButton.Left || !_boxPressed || _boxFrom is not { } from) return CanvasIntent.None;
        _boxPressed = false;
        return from.DistanceTo(at) > DragDistance ? FinishBox(at, _boxRemoves) : CanvasIntent.None;
    }

    /// <summary>A grip, or the first corner of a box at "Select objects", that was pressed and dragged is released here; after a simple click, a second
    /// click gives the point.</summary>
    private CanvasIntent? EndDrag(Point2D at)
    {
        var (grip, point) = (_gripFrom, _pointFrom);
        (_gripFrom, _pointFrom) = (null, null);
        if (grip is { } held && held.DistanceTo(at) > DragDistance) return new CanvasIntent.DropGrip(at);
        return AsksForCorner && point is { } corner && corner.DistanceTo(at) > DragDistance ? new CanvasIntent.SubmitPoint(at) : null;
    }

    /// <param name="notches">Forward (away from the user) is positive and zooms in.</param>
    public CanvasIntent Wheel(Point2D at, double notches)
    {
        _cursor = at;
        return notches == 0.0 ? CanvasIntent.None : new CanvasIntent.Zoom(at, Math.Pow(NotchFactor, notches));
    }

    /// <summary>Cancels the box; without one, Esc goes to the command.</summary>
    public CanvasIntent Escape()
    {
        if (_boxFrom is null) return new CanvasIntent.Cancel();
        DropBox();
        return CanvasIntent.None;
    }

    /// <summary>The view was moved or zoomed: the first corner of a box keeps its position in the drawing.</summary>
    /// <param name="moved">Maps an old position on the screen to the new one.</param>
    public void ViewMoved(Func<Point2D, Point2D> moved) => _boxFrom = _boxFrom is { } from ? moved(from) : null;

    /// <summary>The canvas lost the mouse capture (to another window, for example): no button counts as pressed.</summary>
    public void OnCaptureLost()
    {
        (_panFrom, _gripFrom, _pointFrom) = (null, null, null);
        DropBox();
    }

    private CanvasIntent PressWheel(Point2D at, int clicks)
    {
        _panFrom = clicks >= 2 ? null : at;
        return clicks >= 2 ? new CanvasIntent.ZoomExtents() : CanvasIntent.None;
    }

    /// <summary>The first click may have started a box, which a double click never means.</summary>
    private CanvasIntent.Open OpenAt(Point2D at)
    {
        DropBox();
        return new CanvasIntent.Open(at);
    }

    private CanvasIntent.Select FinishBox(Point2D at, bool remove)
    {
        var box = new SelectionBox(_boxFrom!.Value, at);
        DropBox();
        return new CanvasIntent.Select(box, remove);
    }

    /// <summary>Cancels a box that was started.</summary>
    public void DropBox() => (_boxFrom, _boxPressed, _boxRemoves) = (null, false, false);
}
