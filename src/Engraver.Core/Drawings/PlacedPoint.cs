using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>A POINT of the drawing, in drawing units: shown and snapped to, but not cut.</summary>
/// <param name="Position">In the world, as DXF writes it.</param>
/// <param name="Layer">Index into <see cref="Drawing.Layers"/>.</param>
/// <param name="Colour">As stated; by layer where nothing is.</param>
/// <param name="Hidden">Invisible itself, or because its insert is.</param>
public readonly record struct PlacedPoint(Vector3D Position, int Layer, DrawingColour Colour, bool Hidden)
{
    /// <summary>In plan.</summary>
    public Point2D Plan => new(Position.X, Position.Y);

    /// <summary>Neither itself nor its layer hides it.</summary>
    public bool IsVisibleIn(Drawing drawing) => !Hidden && drawing.Layers[Layer] is { On: true, Frozen: false };
}
