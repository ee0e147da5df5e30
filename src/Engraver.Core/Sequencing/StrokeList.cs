using Engraver.Core.EntityTables;

namespace Engraver.Core.Sequencing;

/// <summary>Strokes as columns in addition to the sequenced table; each is created on demand. A million stored objects would be moved in memory with every
/// garbage collection.</summary>
internal sealed class StrokeList(EntityTable table, int count) : IndexedList<SequencedStroke>
{
    /// <summary>The first row of each stroke; one element more than there are strokes.</summary>
    private readonly int[] _rows = new int[count + 1];
    private readonly bool[] _closed = new bool[count];
    private readonly int[] _segments = new int[count];
    private readonly int[] _inside = new int[count];
    private readonly double[] _lengths = new double[count];
    private int _count;

    public override int Count => _count;

    /// <summary>Adds the next stroke, on the next rows.</summary>
    /// <param name="closed">True when it ends at its start.</param>
    /// <param name="rows">Number of its rows.</param>
    /// <param name="inside">The enclosing stroke, -1 for none.</param>
    /// <param name="curves">Counts lines, arcs and curves.</param>
    public void Add(bool closed, int rows, int inside, CurveCount curves)
    {
        var moves = new StrokeMoveView(table, _rows[_count], rows);
        (_closed[_count], _inside[_count], _segments[_count], _lengths[_count]) = (closed, inside, curves.Add(moves), moves.Length);
        _rows[_count + 1] = _rows[_count] + rows;
        _count++;
    }

    protected override SequencedStroke ItemAt(int index) =>
        new(index, _closed[index], new StrokeMoveView(table, _rows[index], _rows[index + 1] - _rows[index]), _segments[index], _lengths[index], _inside[index]);
}
