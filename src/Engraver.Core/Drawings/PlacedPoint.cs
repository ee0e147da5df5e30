using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>A POINT of the drawing, in drawing units: shown and snapped to, but not cut.</summary>
/// <param name="Position">World coordinates, as DXF writes them.</param>
/// <param name="Layer">Index into <see cref="Drawing.Layers"/>.</param>
/// <param name="Colour">As stated; by layer where none is stated.</param>
/// <param name="Hidden">Invisible itself, or through its insert.</param>
public readonly record struct PlacedPoint(Vector3D Position, int Layer, DrawingColour Colour, bool Hidden)
{
    /// <summary>Linetype as stated, "by block" resolved: index into <see cref="Drawing.Linetypes"/>.</summary>
    public int Linetype { get; init; }

    /// <summary>Index into <see cref="Drawing.BlockPaths"/>; 0 for a point of model space.</summary>
    public int BlockPath { get; init; }

    /// <summary>0 when it has none.</summary>
    public ulong Handle { get; init; }

    /// <summary>Line of the file where it begins (inside a block: the block's point).</summary>
    public int SourceLine { get; init; }

    /// <summary>The position in plan.</summary>
    public Point2D Plan => new(Position.X, Position.Y);

    /// <summary>The point under a similarity of the plane; its height is scaled with it.</summary>
    public PlacedPoint Transformed(Transform2D map) => this with { Position = Position.Transformed(map) };

    /// <summary>True when neither its own state nor its layer hides it.</summary>
    public bool IsVisibleIn(Drawing drawing) => !Hidden && drawing.Layers[Layer] is { On: true, Frozen: false };
}
