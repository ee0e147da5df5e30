using System.Collections;
using Engraver.Core.EntityTables;

namespace Engraver.Core.Sequencing;

/// <summary>Strokes as columns in addition to the sequenced table; each is created on demand. A million stored objects would be moved in memory with every
/// garbage collection.</summary>
internal sealed class StrokeList(EntityTable table, int count) : IReadOnlyList<SequencedStroke>
{
    /// <summary>The first row of each stroke; one element more than there are strokes.</summary>
    private readonly int[] _rows = new int[count + 1];
    private readonly bool[] _closed = new bool[count];
    private readonly int[] _segments = new int[count];
    private readonly int[] _inside = new int[count];
    private readonly double[] _lengths = new double[count];

    public int Count { get; private set; }

    public SequencedStroke this[int index]
    {
        get
        {
            if ((uint)index >= (uint)Count) throw new ArgumentOutOfRangeException(nameof(index));
            return new SequencedStroke(index, _closed[index], new TableMoves(table, _rows[index], _rows[index + 1] - _rows[index]), _segments[index], _lengths[index], _inside[index]);
        }
    }

    /// <summary>Adds the next stroke, on the next rows.</summary>
    /// <param name="closed">True when it ends at its start.</param>
    /// <param name="rows">Number of its rows.</param>
    /// <param name="inside">The enclosing stroke, -1 for none.</param>
    /// <param name="curves">Counts lines, arcs and curves.</param>
    public void Add(bool closed, int rows, int inside, CurveCount curves)
    {
        var moves = new TableMoves(table, _rows[Count], rows);
        (_closed[Count], _inside[Count], _segments[Count], _lengths[Count]) = (closed, inside, curves.Add(moves), moves.Length);
        _rows[Count + 1] = _rows[Count] + rows;
        Count++;
    }

    public IEnumerator<SequencedStroke> GetEnumerator()
    {
        for (var i = 0; i < Count; i++) yield return this[i];
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
}
