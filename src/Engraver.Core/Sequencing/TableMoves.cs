using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>A range of rows of a sequenced table as a list of moves; rows are not copied, so a million moves need no memory in addition to the table.</summary>
internal sealed class TableMoves(EntityTable table, int firstRow, int count) : IndexedList<StrokeMove>
{
    public override int Count => count;

    /// <summary>Length along the path, millimetres.</summary>
    public double Length
    {
        get
        {
            var length = 0.0;
            for (var row = firstRow; row < firstRow + count; row++) length += table[row].ToSegment().Length;
            return length;
        }
    }

    /// <summary>The drawing entity of a move.</summary>
    public int EntityOf(int index) => table.EntityIndexOf(firstRow + index);

    protected override StrokeMove ItemAt(int index) => StrokeMove.From(table[firstRow + index]);
}

/// <summary>One cutting move in millimetres with the drawing entity it came from.</summary>
/// <param name="Segment">Segment in plan.</param>
/// <param name="StartZ">Drawn height at its start; a line rises evenly to its end, an arc is level.</param>
/// <param name="EndZ">Drawn height at its end. Both heights are NaN when the height along the move is unknown: a piece of an ellipse or spline that
/// rises.</param>
public readonly record struct StrokeMove(Segment Segment, int EntityIndex, double StartZ = 0.0, double EndZ = 0.0)
{
    /// <summary>Every row of an analysed table.</summary>
    public static StrokeMove[] AllOf(EntityTable table)
    {
        ArgumentNullException.ThrowIfNull(table);
        var moves = new StrokeMove[table.Count];
        for (var row = 0; row < moves.Length; row++) moves[row] = From(table[row]);
        return moves;
    }

    internal static StrokeMove From(in EntityRow row)
    {
        var isLevel = row.Curve?.IsLevel ?? true;
        return new StrokeMove(row.ToSegment(), row.EntityIndex, isLevel ? row[EntitySlot.StartZ] : double.NaN, isLevel ? row[EntitySlot.EndZ] : double.NaN);
    }
}
