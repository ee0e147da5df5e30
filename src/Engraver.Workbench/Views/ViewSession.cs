using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Views;

/// <summary>The view and its toggles. They are not part of the document: UNDO does not revert a change of view.</summary>
/// <remarks>May be used from any thread; the event is raised on the thread of the change.</remarks>
public sealed class ViewSession
{
    /// <summary>AutoCAD keeps the last 10 views.</summary>
    private const int MaxPrevious = 10;

    private const double MinHeight = 1e-9;
    private const double MaxHeight = 1e12;

    /// <summary>Margin around fitted content, as a fraction of its size.</summary>
    private const double Margin = 0.05;

    private readonly Lock _guard = new();
    private readonly LinkedList<(Point2D Centre, double Height)> _previous = new();
    private (Drawing Drawing, Bounds2D Box)? _extents;

    /// <summary>Raised after the view has changed.</summary>
    public event EventHandler? Changed;

    public ViewState Current { get; private set; } = ViewState.Default;

    /// <summary>Sets the aspect ratio of the canvas, width over height. Ignored unless above 0 and finite.</summary>
    public void SetAspect(double aspect)
    {
        if (aspect > 0.0 && double.IsFinite(aspect)) Change(state => state with { Aspect = aspect });
    }

    /// <summary>Sets the size of the canvas in the units of its control. Ignored unless both are above 0 and finite.</summary>
    public void SetCanvas(double width, double height)
    {
        if (width > 0.0 && height > 0.0 && double.IsFinite(width) && double.IsFinite(height)) Change(state => state with { Aspect = width / height, CanvasHeight = height });
    }

    /// <summary>Changes toggles, overlays or theme without changing the visible part of the drawing.</summary>
    public void Change(Func<ViewState, ViewState> change)
    {
        ArgumentNullException.ThrowIfNull(change);
        lock (_guard)
        {
            var next = change(Current);
            if (next == Current) return;
            Current = next;
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Zooms with the mouse about a fixed point. A factor above 1 enlarges. Not stored for Previous, because a wheel turns often.</summary>
    public void ZoomAbout(Point2D place, double factor)
    {
        if (!(factor > 0.0) || !double.IsFinite(factor) || !place.IsFinite) return;
        Change(state =>
        {
            var height = Math.Clamp(state.Height / factor, MinHeight, MaxHeight);
            return state with { Height = height, Centre = place + ((state.Centre - place) * (height / state.Height)) };
        });
    }

    /// <summary>Moves the drawing on the canvas by a vector, drawing units, like panning with the mouse.</summary>
    public void PanBy(Vector2D way)
    {
        if (double.IsFinite(way.X) && double.IsFinite(way.Y)) Change(state => state with { Centre = state.Centre - way });
    }

    /// <summary>Fits a box to the canvas; stored for Previous. A box without extent is only centred.</summary>
    public void SetWindow(Bounds2D box) => Show(box, 0.0);

    /// <summary>Sets centre and height; stored for Previous.</summary>
    public void SetCentre(Point2D centre, double height)
    {
        Remember();
        Change(state => state with { Centre = centre, Height = Math.Clamp(height, MinHeight, MaxHeight) });
    }

    /// <summary>Fits all visible objects of a drawing; stored for Previous.</summary>
    /// <returns>False if nothing is visible; the view is unchanged.</returns>
    public bool ZoomExtents(Drawing drawing)
    {
        var box = ExtentsOf(drawing);
        if (box.IsEmpty) return false;
        Show(box, Margin);
        return true;
    }

    /// <summary>Fits some curves; stored for Previous.</summary>
    public bool ZoomObjects(Drawing drawing, IEnumerable<int> entities)
    {
        var box = DrawingExtents.Measure(ShownDrawing.Of(drawing), entities);
        if (box.IsEmpty) return false;
        Show(box, Margin);
        return true;
    }

    /// <returns>False if there is no earlier view.</returns>
    public bool ZoomPrevious()
    {
        (Point2D Centre, double Height) view;
        lock (_guard)
        {
            if (_previous.Last is not { } last) return false;
            view = last.Value;
            _previous.RemoveLast();
        }

        Change(state => state with { Centre = view.Centre, Height = view.Height });
        return true;
    }

    /// <summary>Centres and marks a point at a suitable zoom.</summary>
    /// <param name="height">Height of the view, drawing units; null keeps the current one.</param>
    public void FocusOn(ViewFocus focus, double? height)
    {
        ArgumentNullException.ThrowIfNull(focus);
        Remember();
        Change(state => state with { Focus = focus, Centre = focus.Place, Height = height is { } wanted ? Math.Clamp(wanted, MinHeight, MaxHeight) : state.Height });
    }

    /// <summary>Removes the mark of <see cref="FocusOn"/>.</summary>
    public void ClearFocus() => Change(state => state with { Focus = null });

    /// <summary>Raises <see cref="Changed"/>, to redraw everything, and removes the mark of <see cref="FocusOn"/>.</summary>
    public void Regenerate()
    {
        lock (_guard) (Current, _extents) = (Current with { Focus = null }, null);
        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>The bounding box of what is visible, texts included, cached for the last drawing.</summary>
    public Bounds2D ExtentsOf(Drawing drawing)
    {
        lock (_guard)
        {
            if (_extents is { } known && ReferenceEquals(known.Drawing, drawing)) return known.Box;
        }

        var box = DrawingExtents.Measure(ShownDrawing.Of(drawing));
        lock (_guard) _extents = (drawing, box);
        return box;
    }

    private void Show(Bounds2D box, double margin)
    {
        if (box.IsEmpty) return;
        Remember();
        Change(state =>
        {
            var height = Math.Max(box.Height, box.Width / state.Aspect) * (1.0 + (2.0 * margin));
            var centre = new Point2D((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0);
            return state with { Centre = centre, Height = height > 0.0 ? Math.Clamp(height, MinHeight, MaxHeight) : state.Height };
        });
    }

    private void Remember()
    {
        lock (_guard)
        {
            _previous.AddLast((Current.Centre, Current.Height));
            if (_previous.Count > MaxPrevious) _previous.RemoveFirst();
        }
    }
}
