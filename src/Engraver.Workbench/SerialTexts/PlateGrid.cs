using Engraver.Core.Geometry;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The cells of a blank that carries several plates: along X first, then along Y.</summary>
/// <param name="Pitch">From one cell to the next, millimetres; may be negative.</param>
public sealed record PlateGrid(int Columns, int Rows, Vector2D Pitch)
{
    /// <summary>The largest number of columns or rows.</summary>
    public const int MaxCount = 1000;

    public int Cells => Columns * Rows;

    /// <param name="index">Index of the plate in its run; after the last cell the next blank begins.</param>
    public Vector2D OffsetOf(int index) => new(index % Columns * Pitch.X, index % Cells / Columns * Pitch.Y);
}
