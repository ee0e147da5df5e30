using Avalonia;
using Engraver.App.Canvas.Picking;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.Workbench.Views;

namespace Engraver.App.Canvas;

/// <summary>Where a click snaps to: object snaps, the snap raster, ORTHO and polar tracking.</summary>
public sealed partial class DrawingCanvas
{
    /// <summary>A snap was typed for the next place and finds nothing here: a click gives no place.</summary>
    internal bool WaitsForSnap(Point2D at) => View?.Current.OneTimeSnap is > 0 && SnapAt(at) is null;

    /// <summary>The object snap, else the snap raster, else the place itself. With ORTHO the place is level with or upright to the point before, with POLAR
    /// on one of its directions when it is near it, unless an object snap is found.</summary>
    private Point2D Snapped(Point2D at, Point2D? from)
    {
        if (SnapAt(at) is { } snap) return snap.Place;
        if (Tracked(at, from) is { } tracked) return tracked;
        var place = ToDrawing(at);
        if (View?.Current is { Snap: true, SnapSpacing: > 0.0 and var step }) place = new Point2D(Math.Round(place.X / step) * step, Math.Round(place.Y / step) * step);
        if (View?.Current is not { Ortho: true } || from is not { } start) return place;
        return Math.Abs(place.X - start.X) >= Math.Abs(place.Y - start.Y) ? place with { Y = start.Y } : place with { X = start.X };
    }

    /// <summary>The place on a direction of polar tracking; null when there is none near.</summary>
    private Point2D? Tracked(Point2D at, Point2D? from) => View?.Current is { Polar: true } state && from is { } start ? PolarTrack.Find(start, ToDrawing(at), state.PolarAngle, Aperture * UnitsPerPoint) : null;

    private SnapPoint? SnapAt(Point2D at) => Scene is { } scene && View?.Current is { } state && (state.OneTimeSnap ?? (state.ObjectSnap ? state.ObjectSnapModes : 0)) is > 0 and var modes
        ? ObjectSnap.Find(scene, ToDrawing(at), Aperture * UnitsPerPoint, (SnapKinds)modes, _aim?.From)
        : null;

    /// <summary>The line from the point before through a tracked place, to beyond the canvas; null when nothing is tracked.</summary>
    private (Point From, Point To)? TrackOf(Point2D at)
    {
        if (_aim?.From is not { } from || SnapAt(at) is not null || Tracked(at, from) is not { } place) return null;
        var (start, end) = (ToControl(from), ToControl(place));
        var way = new Point2D(end.X, end.Y) - new Point2D(start.X, start.Y);
        if (way.Length == 0.0) return null;
        var far = way * ((Bounds.Width + Bounds.Height + way.Length) / way.Length);
        return (start, new Point(start.X + far.X, start.Y + far.Y));
    }

    /// <summary>What the text beside the crosshair begins with: the snap that was typed, or that the place is tracked.</summary>
    private string TipBefore(Point2D at) => View?.Current.OneTimeSnap is { } once ? SnapNames.Text(once) + "\n" : _cursor.Track is not null ? Texts.Text.Get("Canvas.Polar") + " " : "";
}
