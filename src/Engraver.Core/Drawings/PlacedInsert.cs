using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>One copy of a block in the drawing, in drawing units.</summary>
/// <param name="Path">Index into <see cref="Drawing.BlockPaths"/>.</param>
/// <param name="Around">Number of the insert in which it is nested; 0 in model space.</param>
/// <param name="Position">Its insertion point, world coordinates.</param>
/// <param name="Layer">Index into <see cref="Drawing.Layers"/>: its effective layer.</param>
/// <param name="Hidden">Invisible itself or through an insert around it.</param>
public readonly record struct PlacedInsert(int Path, int Around, Vector3D Position, int Layer, bool Hidden)
{
    /// <summary>Every curve of it was erased.</summary>
    public bool IsErased { get; init; }

    /// <summary>The same insert at another place; its height is scaled with the map.</summary>
    public PlacedInsert Moved(Transform2D map)
    {
        var place = map.Apply(Plan);
        return this with { Position = new Vector3D(place.X, place.Y, Position.Z * map.Scale) };
    }

    /// <summary>The position in plan.</summary>
    public Point2D Plan => new(Position.X, Position.Y);
}
