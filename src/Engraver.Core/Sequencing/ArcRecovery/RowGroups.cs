namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>Joins rows to groups, pair by pair (union-find, the smaller group under the larger).</summary>
internal sealed class RowGroups
{
    /// <summary>The parent row in the group's tree; the root holds the group's size, negative.</summary>
    private readonly int[] _above;

    public RowGroups(int rows)
    {
        _above = new int[rows];
        Array.Fill(_above, -1);
        Largest = Math.Min(1, rows);
    }

    /// <summary>Rows in the largest group.</summary>
    public int Largest { get; private set; }

    /// <summary>The root row of a row's group.</summary>
    public int Of(int row)
    {
        while (_above[row] >= 0)
        {
            if (_above[_above[row]] >= 0) _above[row] = _above[_above[row]];
            row = _above[row];
        }

        return row;
    }

    public int SizeOf(int row) => -_above[Of(row)];

    public void Join(int one, int other)
    {
        var (large, small) = (Of(one), Of(other));
        if (large == small) return;
        if (_above[large] > _above[small]) (large, small) = (small, large);
        _above[large] += _above[small];
        _above[small] = large;
        Largest = Math.Max(Largest, -_above[large]);
    }
}
