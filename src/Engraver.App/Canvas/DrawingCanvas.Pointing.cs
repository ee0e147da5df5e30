using Avalonia;
using Engraver.App.Canvas.Interaction;
using Engraver.App.Canvas.Picking;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Objects;

namespace Engraver.App.Canvas;

/// <summary>Where the cursor points, and the drafting aids: pickbox, object snaps, snap raster, ORTHO, the line or box from the point before, and the text
/// beside the crosshair.</summary>
public sealed partial class DrawingCanvas
{
    /// <summary>Chords of a ghost's arc to a whole turn, and of a curve.</summary>
    private const int GhostChords = 72;

    /// <summary>How near the cursor must come to a grip, units of the control.</summary>
    private const double GripReach = 6.0;

    /// <summary>Segments of a ghost that are drawn at most.</summary>
    private const int MostGhostSegments = 20_000;

    private PointAim? _aim;
    private GhostOf? _preview;

    /// <summary>The grip that is dragged, drawing units; null: none is.</summary>
    private Point2D? _held;

    /// <summary>Half the side of the box in which object snaps are found, units of the control (APERTURE).</summary>
    public double Aperture { get; set; } = 10.0;

    /// <summary>How coordinates, distances and angles are shown beside the crosshair (LUPREC, AUPREC).</summary>
    public Figures Figures { get; set; } = Figures.Usual;

    /// <summary>The text beside the crosshair; empty for none.</summary>
    internal string Tip => _cursor.Tip;

    /// <summary>The box from the first corner that a command has to the cursor, or the one that is being drawn; units of the control.</summary>
    internal SelectionBox? Box => _cursor.Box;

    /// <summary>The entity that lights up under the cursor; null: none does.</summary>
    internal int? Hovered => _signs.Hovered;

    /// <summary>What a click, or Enter, would give, drawing units.</summary>
    internal IReadOnlyList<Segment> Ghost => _ghosts.Shown;

    private double UnitsPerPoint => _keeper.View.UnitsPerPixel * Scaling;

    private bool AsksForPlace => _aim is not (null or { Use: PointUse.Object });

    /// <summary>Looks what the command asks for now, so that the cursor shows it before the mouse moves.</summary>
    public void TakeAim()
    {
        if (LookWhatIsAsked()) PointAgain();
    }

    /// <summary>The entity under the pickbox when it stands here (units of the control); null: none.</summary>
    internal int? EntityAt(Point2D at) => Scene is { } scene ? ScenePick.Nearest(scene, ToDrawing(at), PickBox * UnitsPerPoint) : null;

    /// <summary>The grip under the cursor (units of the control), where grips are shown; null: none.</summary>
    internal Grip? GripAt(Point2D at)
    {
        if (_signs.Grips.Count == 0) return null;
        var (place, nearest) = (ToDrawing(at), default(Grip?));
        foreach (var grip in _signs.Grips)
        {
            if (grip.Place.DistanceTo(place) <= (nearest?.Place.DistanceTo(place) ?? (GripReach * UnitsPerPoint))) nearest = grip;
        }

        return nearest;
    }

    /// <returns>True when the command asks for something else than before.</returns>
    private bool LookWhatIsAsked()
    {
        var before = (_aim, _preview);
        (_aim, _preview) = (Commands?.Aim, Commands?.Preview);
        (_pointer.AsksForPoint, _pointer.AsksForCorner) = (_aim is not null, _aim is { Use: PointUse.Corner });
        if (before._aim is not null && _aim is null) LetGo();
        return (_aim, _preview) != before;
    }

    /// <summary>No grip is held any longer.</summary>
    private void LetGo()
    {
        if (_held is null) return;
        _held = null;
        UpdateSigns();
    }

    private Point2D ToDrawing(Point2D at) => _keeper.View.ToDrawing(new Point2D(at.X * Scaling, at.Y * Scaling));

    private Point ToControl(Point2D place)
    {
        var pixel = _keeper.View.ToPixels(place);
        return new Point(pixel.X / Scaling, pixel.Y / Scaling);
    }

    private void Hover(Point2D at)
    {
        LookWhatIsAsked();
        var hovered = AsksForPlace || _pointer.Box is not null ? null : EntityAt(at);
        var grip = _aim is null && _pointer.Box is null ? GripAt(at)?.Place : null;
        if (grip is not null) hovered = null;
        if (hovered != _signs.Hovered || grip != _signs.HoveredGrip)
        {
            (_signs.Hovered, _signs.HoveredGrip) = (hovered, grip);
            _signs.InvalidateVisual();
        }

        _cursor.Snap = _aim is { Use: PointUse.Place } && SnapAt(at) is { } snap ? (ToControl(snap.Place), snap.Kind) : null;
        Commands?.CursorAt(Aimed(at));
    }

    /// <summary>Points again after the drawing moved under the cursor, the command asks for something else, or a drafting aid changed.</summary>
    private void PointAgain()
    {
        if (_cursor.Place is { } at) Hover(new Point2D(at.X, at.Y));
        ShowCursor();
    }

    private void ShowCursor()
    {
        Point2D? at = _cursor.Place is { } cursor ? new Point2D(cursor.X, cursor.Y) : null;
        var from = _aim?.From is { } known ? ToControl(known) : default(Point?);
        _cursor.Box = _pointer.Box ?? (_aim is { Use: PointUse.Corner } && from is { } corner && at is { } opposite ? new SelectionBox(new Point2D(corner.X, corner.Y), opposite) : null);
        _cursor.Line = _aim is { Use: PointUse.Place } && from is { } start && at is { } end ? (start, ToControl(Aimed(end))) : null;
        _cursor.Track = _aim is { Use: PointUse.Place } && at is { } tracked ? TrackOf(tracked) : null;
        _cursor.Tip = _aim is { } aim && at is { } place && View?.Current is { DynamicInput: true } ? CursorTip.Format(Commands?.Asked ?? "", aim, Aimed(place), Figures, TipBefore(place)) : "";
        if (_preview is { } preview) _ghosts.Want(preview, default(Point2D));
        else _ghosts.Want(_aim?.Ghost, at is { } pointed ? Aimed(pointed) : null);
        _cursor.Ghost = [.. _ghosts.Shown.Take(MostGhostSegments).Select(Chords)];
        (_cursor.AsksForPoint, _cursor.PickBox) = (AsksForPlace, PickBox);
        _cursor.InvalidateVisual();
    }

    private Point[] Chords(Segment segment)
    {
        var chords = segment.Kind == SegmentKind.Line ? 1 : segment.IsFreeCurve ? GhostChords : 1 + (int)(Math.Abs(segment.Arc.Sweep.Degrees) / 360.0 * GhostChords);
        return [.. Enumerable.Range(0, chords + 1).Select(i => ToControl(segment.PointAt((double)i / chords)))];
    }

    /// <summary>The place that a click here gives, drawing units.</summary>
    /// <remarks>A grip may be dragged and let go before its command has asked where to.</remarks>
    private Point2D Aimed(Point2D at) => _aim is { Use: PointUse.Place } aim ? Snapped(at, aim.From) : _aim is null && _held is { } grip ? Snapped(at, grip) : ToDrawing(at);
}
