using System.Diagnostics.CodeAnalysis;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Scenes;

/// <summary>One line, arc, circle or free curve prepared for drawing, drawing units. 40 bytes, so that two cores process a million of them in a few
/// milliseconds.</summary>
/// <remarks>Line: A,B start, C,D end. Arc and circle: A,B centre, C radius, D index into the store's arcs. Ellipse and spline: A index into the store's
/// curves.</remarks>
[SuppressMessage("Design", "CA1051", Justification = "A row of a column, written through a reference.")]
internal struct ScenePrimitive
{
    public double A;
    public double B;
    public double C;
    public double D;

    /// <summary>The owner: for a drawing, the index of the entity.</summary>
    public int Entity;

    /// <summary>Index into the palette.</summary>
    public ushort Colour;

    public SegmentKind Kind;

    public static ScenePrimitive Line(Point2D from, Point2D to, int entity, ushort colour) =>
        new() { A = from.X, B = from.Y, C = to.X, D = to.Y, Entity = entity, Colour = colour, Kind = SegmentKind.Line };
}
