using Engraver.App.Canvas.Colours;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Scenes;

/// <summary>A drawing made ready for the canvas, once for each state of the document. It may be drawn and searched from all threads. Entities that are
/// hidden or on layers that are off or frozen are not in it.</summary>
/// <remarks>Where entities cross, the one that is drawn on top follows from where they are, not from the order of the drawing.</remarks>
public sealed class CanvasScene
{
    private CanvasScene(Drawing drawing, EntityColours colours, PrimitiveStore store)
    {
        Drawing = drawing;
        Colours = colours;
        Store = store;
        Points = drawing.Points.Count == 0 ? [] : [.. drawing.Points.Where(point => point.IsVisibleIn(drawing))];
        PointColours = Points.ToLookup(point => (point.Colour.Resolved(drawing.Layers[point.Layer].Colour, DrawingColour.Foreground), drawing.Layers[point.Layer].Locked), point => point.Plan);
    }

    public Drawing Drawing { get; }

    public EntityColours Colours { get; }

    /// <summary>Tight box of what is visible; empty when nothing is.</summary>
    public Bounds2D Extents => Store.Bounds;

    /// <summary>Lines, arcs, circles and curves in it.</summary>
    public int PrimitiveCount => Store.Count;

    internal PrimitiveStore Store { get; }

    /// <summary>The points that can be seen.</summary>
    internal IReadOnlyList<PlacedPoint> Points { get; }

    /// <summary>Their places by their colours, an index or a true colour, faded on locked layers.</summary>
    internal ILookup<(DrawingColour Colour, bool IsFaded), Point2D> PointColours { get; }

    /// <param name="colours">Colours of the entities; null: those that the drawing states.</param>
    public static CanvasScene From(Drawing drawing, EntityColours? colours = null)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        var known = colours ?? EntityColours.From(drawing);
        return new CanvasScene(drawing, known, DrawingPrimitives.Create(drawing, known));
    }
}
