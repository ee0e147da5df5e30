using System.Collections;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>A range of rows of a sequenced table as a list of moves; nothing is copied, so a million moves cost no memory besides the table.</summary>
internal sealed class TableMoves(EntityTable table, int firstRow, int count) : IReadOnlyList<StrokeMove>
{
    public int Count => count;

    public StrokeMove this[int index]
    {
        get
        {
            if ((uint)index >= (uint)count) throw new ArgumentOutOfRangeException(nameof(index));
            var row = table[firstRow + index];
            return new StrokeMove(row.ToSegment(), row.EntityIndex);
        }
    }

    public IEnumerator<StrokeMove> GetEnumerator()
    {
        for (var i = 0; i < count; i++) yield return this[i];
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
}

/// <summary>One cutting move in millimetres with the drawing entity it came from.</summary>
public readonly record struct StrokeMove(Segment Segment, int EntityIndex);
