using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The cells of a blank that carries several plates: along X first, then along Y.</summary>
/// <param name="Pitch">From one cell to the next, millimetres; may be negative.</param>
public sealed record PlateGrid(int Columns, int Rows, Vector2D Pitch)
{
    /// <summary>The largest number of columns or rows.</summary>
    public const int MaxCount = 1000;

    /// <summary>X: displacement of every second row along X. Y: displacement of every second column along Y. Millimetres.</summary>
    public Vector2D Stagger { get; init; }

    /// <summary>Where the grid as a whole is on its blank, and the side that is cut.</summary>
    public DrawingPlacement Placement { get; init; } = DrawingPlacement.None;

    public int Cells => Columns * Rows;

    /// <summary>The place of a plate, from where the drawing alone would be; millimetres.</summary>
    /// <param name="index">Index of the plate in its run; after the last cell the next blank begins.</param>
    public Vector2D OffsetOf(int index) => Placement.Turned(CellAt(index % Columns, index % Cells / Columns) + Shift());

    private Vector2D CellAt(int column, int row) => new((column * Pitch.X) + (row % 2 * Stagger.X), (row * Pitch.Y) + (column % 2 * Stagger.Y));

    /// <summary>The drawing alone is at its place on the blank: this brings the whole grid there.</summary>
    private Vector2D Shift()
    {
        if (Placement.Place == BlankPlace.None) return default;
        int[] columns = [0, Math.Min(1, Columns - 1), Math.Max(0, Columns - 2), Columns - 1];
        int[] rows = [0, Math.Min(1, Rows - 1), Math.Max(0, Rows - 2), Rows - 1];
        var box = columns.SelectMany(column => rows.Select(row => CellAt(column, row))).Aggregate(Bounds2D.Empty, (all, cell) => all.Including(Point2D.Origin + cell));
        return (Placement with { Blank = default }).PlaceShift(box);
    }
}
