using Avalonia;
using Engraver.App.Canvas.Picking;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.Workbench.Views;

namespace Engraver.App.Canvas;

/// <summary>Where a click snaps to: object snaps, the snap raster, ORTHO and polar tracking. Cursor positions are in units of the control, results in drawing
/// units.</summary>
internal sealed class DraftingAids(DrawingCanvas canvas)
{
    /// <summary>Half the side of the box in which object snaps are found, units of the control (APERTURE).</summary>
    public double Aperture { get; set; } = 10.0;

    /// <summary>A snap was typed for the next point and finds nothing here: a click gives no point.</summary>
    /// <param name="before">The point before, for perpendicular and tangent snaps.</param>
    public bool WaitsForSnap(Point2D at, Point2D? before) => canvas.View?.Current.OneTimeSnap is > 0 && SnapAt(at, before) is null;

    /// <summary>The object snap, else the snap raster, else the point itself. With ORTHO the point is level with or upright to another one, with POLAR on one
    /// of its directions when it is near it, unless an object snap is found.</summary>
    /// <param name="before">The point before, for perpendicular and tangent snaps.</param>
    /// <param name="from">The point from which ORTHO and POLAR measure.</param>
    public Point2D Snap(Point2D at, Point2D? before, Point2D? from)
    {
        if (SnapAt(at, before) is { } snap) return snap.Place;
        if (Tracked(at, from) is { } tracked) return tracked;
        var place = canvas.ToDrawing(at);
        if (canvas.View?.Current is { Snap: true, SnapSpacing: > 0.0 and var step }) place = new Point2D(Math.Round(place.X / step) * step, Math.Round(place.Y / step) * step);
        if (canvas.View?.Current is not { Ortho: true } || from is not { } start) return place;
        return Math.Abs(place.X - start.X) >= Math.Abs(place.Y - start.Y) ? place with { Y = start.Y } : place with { X = start.X };
    }

    /// <summary>The object snap near the cursor; null when there is none, or none is on.</summary>
    public SnapPoint? SnapAt(Point2D at, Point2D? before) => canvas.Scene is { } scene && canvas.View?.Current is { } state && (state.OneTimeSnap ?? (state.ObjectSnap ? state.ObjectSnapModes : 0)) is > 0 and var modes
        ? ObjectSnap.Find(scene, canvas.ToDrawing(at), Aperture * canvas.UnitsPerPoint, (SnapKinds)modes, before)
        : null;

    /// <summary>The line from the point before through a tracked point, to beyond the canvas; null when nothing is tracked.</summary>
    public (Point From, Point To)? TrackOf(Point2D at, Point2D? before)
    {
        if (before is not { } from || SnapAt(at, from) is not null || Tracked(at, from) is not { } place) return null;
        var (start, end) = (canvas.ToControl(from), canvas.ToControl(place));
        var way = new Point2D(end.X, end.Y) - new Point2D(start.X, start.Y);
        if (way.Length == 0.0) return null;
        var far = way * ((canvas.Bounds.Width + canvas.Bounds.Height + way.Length) / way.Length);
        return (start, new Point(start.X + far.X, start.Y + far.Y));
    }

    /// <summary>The beginning of the text beside the crosshair: the snap that was typed, or that the point is tracked.</summary>
    public string TipPrefix(bool isTracked) => canvas.View?.Current.OneTimeSnap is { } once ? SnapNames.Text(once) + "\n" : isTracked ? Texts.Text.Get("Canvas.Polar") + " " : "";

    /// <summary>The point on a direction of polar tracking; null when there is none near.</summary>
    private Point2D? Tracked(Point2D at, Point2D? from) =>
        canvas.View?.Current is { Polar: true } state && from is { } start ? PolarTrack.Find(start, canvas.ToDrawing(at), state.PolarAngle, Aperture * canvas.UnitsPerPoint) : null;
}
