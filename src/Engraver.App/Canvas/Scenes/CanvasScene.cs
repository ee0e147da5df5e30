using Engraver.App.Canvas.Colours;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.App.Canvas.Scenes;

/// <summary>A drawing prepared for the canvas, once for each state of the document. It may be drawn and searched from all threads. Hidden entities and
/// entities on layers that are off or frozen are excluded.</summary>
/// <remarks>Where entities cross, the order of drawing depends on their positions, not on their order in the drawing.</remarks>
public sealed class CanvasScene
{
    private CanvasScene(Drawing drawing, Drawing shown, EntityColours colours, PrimitiveStore store)
    {
        (Drawing, Shown) = (drawing, shown);
        Colours = colours;
        Store = store;
        Points = drawing.Points.Count == 0 ? [] : [.. drawing.Points.Where(point => point.IsVisibleIn(drawing))];
        PointColours = Points.ToLookup(point => (point.Colour.Resolved(drawing.Layers[point.Layer].Colour, DrawingColour.Foreground), drawing.Layers[point.Layer].Locked), point => point.Plan);
    }

    /// <summary>The drawing of the document.</summary>
    public Drawing Drawing { get; }

    /// <summary>The drawing with the letters of its texts as curves, to which the entity indices of the scene refer.</summary>
    public Drawing Shown { get; }

    public EntityColours Colours { get; }

    /// <summary>Tight box of the visible entities; empty if there are none.</summary>
    public Bounds2D Extents => Store.Bounds;

    /// <summary>Number of lines, arcs, circles and curves.</summary>
    public int PrimitiveCount => Store.Count;

    internal PrimitiveStore Store { get; }

    /// <summary>The visible points.</summary>
    internal IReadOnlyList<PlacedPoint> Points { get; }

    /// <summary>Positions of the points by colour (an index or a true colour), faded on locked layers.</summary>
    internal ILookup<(DrawingColour Colour, bool IsFaded), Point2D> PointColours { get; }

    /// <param name="colours">Colours of the entities; null: those that the drawing defines.</param>
    public static CanvasScene From(Drawing drawing, EntityColours? colours = null)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        var shown = ShownDrawing.Of(drawing);
        var known = colours ?? EntityColours.From(shown);
        return new CanvasScene(drawing, shown, known, DrawingPrimitives.Create(shown, known));
    }
}
