using System.Collections;
using Engraver.Core.EntityTables;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Sequencing;

/// <summary>A run of rows of a sequenced table seen as moves: nothing is copied, so a million moves cost the table and no more.</summary>
internal sealed class TableMoves(EntityTable table, int firstRow, int count) : IReadOnlyList<ToolpathMove>
{
    public int Count => count;

    public ToolpathMove this[int index]
    {
        get
        {
            if ((uint)index >= (uint)count) throw new ArgumentOutOfRangeException(nameof(index));
            var row = table[firstRow + index];
            return new ToolpathMove(row.ToSegment(), row.EntityIndex);
        }
    }

    public IEnumerator<ToolpathMove> GetEnumerator()
    {
        for (var i = 0; i < count; i++) yield return this[i];
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
}
