using Engraver.Core.EntityTables;

namespace Engraver.Core.Sequencing;

/// <summary>A range of rows of a sequenced table as a list of moves; rows are not copied, so a million moves need no memory in addition to the table.</summary>
internal sealed class StrokeMoveView(EntityTable table, int firstRow, int count) : IndexedList<StrokeMove>
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
