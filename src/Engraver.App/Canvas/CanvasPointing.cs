using Avalonia;
using Engraver.App.Canvas.Interaction;
using Engraver.App.Canvas.Picking;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Objects;
using Engraver.Workbench.Views;

namespace Engraver.App.Canvas;

/// <summary>What the cursor points at, and what the mouse does there: from its events to intents, and from intents to the view and the commands.</summary>
internal sealed class CanvasPointing
{
    private const double FindingReach = 9.0;
    private const double FindingZoom = 8.0;

    /// <summary>60, the first value of ZOOMFACTOR, zooms by a quarter a notch.</summary>
    private const double ZoomFactorOfAQuarter = 240.0;

    /// <summary>Chords of a ghost's arc to a whole turn, and of a curve.</summary>
    private const int GhostChords = 72;

    /// <summary>How near the cursor must come to a grip, units of the control.</summary>
    private const double GripReach = 6.0;

    /// <summary>Segments of a ghost that are drawn at most.</summary>
    private const int MaxGhostSegments = 20_000;

    private readonly DrawingCanvas _canvas;
    private readonly CanvasMarkers _signs;
    private readonly CanvasCursor _cursor;
    private readonly GhostRunner _ghosts;
    private PointRequest? _aim;
    private GhostFunction? _preview;

    public CanvasPointing(DrawingCanvas canvas, CanvasMarkers signs, CanvasCursor cursor)
    {
        (_canvas, _signs, _cursor) = (canvas, signs, cursor);
        Aids = new DraftingAids(canvas);
        _ghosts = new GhostRunner(ShowCursor);
    }

    /// <summary>What presses and movements mean.</summary>
    public PointerStateMachine Pointer { get; } = new();

    public DraftingAids Aids { get; }

    /// <summary>Half the side of the pickbox, in units of the control (PICKBOX).</summary>
    public double PickBox { get; set; } = 4.0;

    /// <summary>How far one step of the wheel zooms, 3 to 100 (ZOOMFACTOR).</summary>
    public double ZoomFactor { get; set; } = 60.0;

    /// <summary>The wheel turned forward zooms out (ZOOMWHEEL).</summary>
    public bool ReversesWheel { get; set; }

    /// <summary>How coordinates, distances and angles are shown beside the crosshair (LUPREC, AUPREC).</summary>
    public DisplayPrecision Figures { get; set; } = DisplayPrecision.Initial;

    /// <summary>The text beside the crosshair; empty for none.</summary>
    public string Tip => _cursor.Tip;

    /// <summary>The box from the first corner that a command has to the cursor, or the one that is being drawn; units of the control.</summary>
    public SelectionBox? Box => _cursor.Box;

    /// <summary>The entity that is highlighted under the cursor; null: none is.</summary>
    public int? Hovered => _signs.Hovered;

    /// <summary>What a click, or Enter, would give, drawing units.</summary>
    public IReadOnlyList<Segment> Ghost => _ghosts.Shown;

    /// <summary>The grip that is dragged, drawing units; null: none is.</summary>
    public Point2D? HeldGrip { get; private set; }

    private bool AsksForPlace => _aim is not (null or { Purpose: PointPurpose.Object });

    public void Press(Point2D at, PointerButton button, bool shift, int clicks)
    {
        UpdateAim();
        if (_aim is null) ReleaseGrip();
        Execute(Pointer.Press(at, button, shift, clicks, () => EntityAt(at) is not null, () => GripAt(at) is not null));
    }

    public void Move(Point2D at)
    {
        _cursor.Place = new Point(at.X, at.Y);
        Execute(Pointer.Move(at));
    }

    /// <param name="button">Null for a button that means nothing here.</param>
    public void Release(Point2D at, PointerButton? button)
    {
        UpdateAim();
        if (button is { } released) Execute(Pointer.Release(at, released));
    }

    /// <param name="notches">Positive: turned forward.</param>
    public void Wheel(Point2D at, double notches)
    {
        Pointer.NotchFactor = 1.0 + (ZoomFactor / ZoomFactorOfAQuarter);
        Execute(Pointer.Wheel(at, ReversesWheel ? -notches : notches));
    }

    /// <summary>The cursor has left the canvas.</summary>
    public void Leave()
    {
        (_cursor.Place, _cursor.Snap, _signs.Hovered, _signs.HoveredGrip) = (null, null, null, null);
        _canvas.UpdateMarkers();
        ShowCursor();
        _canvas.Commands?.CursorAt(null);
    }

    /// <summary>Esc, wherever the focus is: the shell calls it after the machine has had its turn.</summary>
    public void Escape() => Execute(Pointer.Escape());

    /// <summary>Reads what the command asks for now, so that the cursor shows it before the mouse moves.</summary>
    public void UpdatePointRequest()
    {
        if (UpdateAim()) RepeatMove();
    }

    /// <summary>Another scene is shown: what was hovered may be gone or have another number, and a box that was started was meant for the scene
    /// before.</summary>
    public void DropScene()
    {
        Pointer.DropBox();
        (_signs.Hovered, _signs.HoveredGrip) = (null, null);
    }

    /// <summary>Points again after the drawing moved under the cursor, the command asks for something else, or a drafting aid changed.</summary>
    public void RepeatMove()
    {
        if (_cursor.Place is { } at) Hover(new Point2D(at.X, at.Y));
        ShowCursor();
    }

    /// <summary>The entity under the pickbox when it is here (units of the control); null: none.</summary>
    public int? EntityAt(Point2D at) => _canvas.Scene is { } scene ? ScenePick.Nearest(scene, _canvas.ToDrawing(at), PickBox * _canvas.UnitsPerPoint) : null;

    /// <summary>The grip under the cursor (units of the control), where grips are shown; null: none.</summary>
    public Grip? GripAt(Point2D at)
    {
        if (_signs.Grips.Count == 0) return null;
        var (place, nearest) = (_canvas.ToDrawing(at), default(Grip?));
        foreach (var grip in _signs.Grips)
        {
            if (grip.Place.DistanceTo(place) <= (nearest?.Place.DistanceTo(place) ?? (GripReach * _canvas.UnitsPerPoint))) nearest = grip;
        }

        return nearest;
    }

    /// <returns>True when the command asks for something else than before.</returns>
    private bool UpdateAim()
    {
        var before = (_aim, _preview);
        (_aim, _preview) = (_canvas.Commands?.Aim, _canvas.Commands?.Preview);
        (Pointer.AsksForPoint, Pointer.AsksForCorner) = (_aim is not null, _aim is { Purpose: PointPurpose.Corner });
        if (before._aim is not null && _aim is null) ReleaseGrip();
        return (_aim, _preview) != before;
    }

    private void ReleaseGrip()
    {
        if (HeldGrip is null) return;
        HeldGrip = null;
        _canvas.UpdateMarkers();
    }

    private void Hover(Point2D at)
    {
        UpdateAim();
        var hovered = AsksForPlace || Pointer.Box is not null ? null : EntityAt(at);
        var grip = _aim is null && Pointer.Box is null ? GripAt(at)?.Place : null;
        if (grip is not null) hovered = null;
        if (hovered != _signs.Hovered || grip != _signs.HoveredGrip)
        {
            (_signs.Hovered, _signs.HoveredGrip) = (hovered, grip);
            _signs.InvalidateVisual();
        }

        _cursor.Snap = _aim is { Purpose: PointPurpose.Place } && Aids.SnapAt(at, _aim?.From) is { } snap ? (_canvas.ToControl(snap.Place), snap.Kind) : null;
        _canvas.Commands?.CursorAt(SnappedPoint(at));
    }

    private void ShowCursor()
    {
        Point2D? at = _cursor.Place is { } cursor ? new Point2D(cursor.X, cursor.Y) : null;
        var from = _aim?.From is { } known ? _canvas.ToControl(known) : default(Point?);
        _cursor.Box = Pointer.Box ?? (_aim is { Purpose: PointPurpose.Corner } && from is { } corner && at is { } opposite ? new SelectionBox(new Point2D(corner.X, corner.Y), opposite) : null);
        _cursor.Line = _aim is { Purpose: PointPurpose.Place } && from is { } start && at is { } end ? (start, _canvas.ToControl(SnappedPoint(end))) : null;
        _cursor.Track = _aim is { Purpose: PointPurpose.Place } && at is { } tracked ? Aids.TrackOf(tracked, _aim?.From) : null;
        _cursor.Tip = _aim is { } aim && at is { } place && _canvas.View?.Current is { DynamicInput: true } ? CursorTip.Format(_canvas.Commands?.Instruction ?? "", aim, SnappedPoint(place), Figures, Aids.TipPrefix(_cursor.Track is not null)) : "";
        if (_preview is { } preview) _ghosts.Request(preview, default(Point2D));
        else _ghosts.Request(_aim?.Ghost, at is { } pointed ? SnappedPoint(pointed) : null);
        _cursor.Ghost = [.. _ghosts.Shown.Take(MaxGhostSegments).Select(Chords)];
        (_cursor.AsksForPoint, _cursor.PickBox) = (AsksForPlace, PickBox);
        _cursor.InvalidateVisual();
    }

    private Point[] Chords(Segment segment)
    {
        var chords = segment.Kind == SegmentKind.Line ? 1 : segment.IsFreeCurve ? GhostChords : 1 + (int)(Math.Abs(segment.Arc.Sweep.Degrees) / 360.0 * GhostChords);
        return [.. Enumerable.Range(0, chords + 1).Select(i => _canvas.ToControl(segment.PointAt((double)i / chords)))];
    }

    /// <summary>The point that a click here gives, drawing units.</summary>
    /// <remarks>A grip may be dragged and released before its command has asked for the target.</remarks>
    private Point2D SnappedPoint(Point2D at) => _aim is { Purpose: PointPurpose.Place } aim ? Aids.Snap(at, aim.From, aim.From) : _aim is null && HeldGrip is { } grip ? Aids.Snap(at, null, grip) : _canvas.ToDrawing(at);

    private void Execute(CanvasIntent intent)
    {
        switch (intent)
        {
            case CanvasIntent.Pan pan:
                _canvas.View?.PanBy(new Vector2D(pan.By.X * _canvas.UnitsPerPoint, -pan.By.Y * _canvas.UnitsPerPoint));
                break;
            case CanvasIntent.Zoom zoom:
                _canvas.View?.ZoomAbout(_canvas.ToDrawing(zoom.About), zoom.Factor);
                break;
            case CanvasIntent.Hover hover:
                Hover(hover.At);
                break;
            case CanvasIntent.Select select:
                _canvas.Commands?.SelectBox(_canvas.ToDrawing(select.Box.From), _canvas.ToDrawing(select.Box.To), select.Box.IsCrossing, select.Remove);
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
        if (_canvas.Commands is not { } commands) return;
        if (intent is CanvasIntent.ZoomExtents) commands.ZoomExtents();
        else if (intent is CanvasIntent.Cancel) commands.Cancel();
        else if (intent is CanvasIntent.Menu menu) commands.Menu(_canvas.ToDrawing(menu.At));
        else if (intent is CanvasIntent.SubmitPoint given) SubmitPoint(commands, given);
        else if (intent is CanvasIntent.GrabGrip hold && GripAt(hold.At) is { } grip) HoldGrip(commands, grip.Place);
        else if (intent is CanvasIntent.DropGrip drop) commands.GripDropped(SnappedPoint(drop.At));
        else if (intent is CanvasIntent.Pick pick && EntityAt(pick.At) is { } entity) commands.PickAt(_canvas.ToDrawing(pick.At), entity, _canvas.Scene!.Drawing, pick.Remove);
    }

    private void HoldGrip(ICanvasCommands commands, Point2D grip)
    {
        HeldGrip = grip;
        _canvas.UpdateMarkers();
        commands.GripPressed(grip);
    }

    private void SubmitPoint(ICanvasCommands commands, CanvasIntent.SubmitPoint given)
    {
        if (_aim is not { Purpose: PointPurpose.Place } || !Aids.WaitsForSnap(given.At, _aim.From)) commands.PointGiven(SnappedPoint(given.At), given.Remove);
    }

    /// <summary>Brings the finding under the cursor into the middle, nearer by <see cref="FindingZoom"/>.</summary>
    private void ShowFinding(Point2D at)
    {
        var place = _canvas.ToDrawing(at);
        if (_canvas.View is not { } view || !view.Current.Shown.HasFlag(CanvasLayers.Findings)) return;
        if (_canvas.Overlay?.FindingNear(place, FindingReach * _canvas.UnitsPerPoint) is { } finding) view.FocusOn(new ViewFocus(finding, null), view.Current.Height / FindingZoom);
    }
}
