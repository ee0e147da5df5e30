using System.Runtime.CompilerServices;

namespace Engraver.Core.Drawings;

/// <summary>A column of values that grows in chunks: appending does not copy existing values, so a million rows need no more than their own size.</summary>
public sealed class GrowingColumn<T>
    where T : struct
{
    private const int ChunkShift = 12;
    private const int ChunkSize = 1 << ChunkShift;
    private readonly List<T[]> _chunks = [];

    /// <summary>The chunk that is being filled.</summary>
    private T[] _last = [];

    public int Count { get; private set; }

    public ref T this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            if ((uint)index >= (uint)Count) throw new ArgumentOutOfRangeException(nameof(index));
            return ref _chunks[index >> ChunkShift][index & (ChunkSize - 1)];
        }
    }

    /// <summary>Appends a value and returns its index.</summary>
    public int Add(in T value)
    {
        var place = Count & (ChunkSize - 1);
        if (place == 0) _chunks.Add(_last = GC.AllocateUninitializedArray<T>(ChunkSize));
        _last[place] = value;
        return Count++;
    }

    /// <summary>A column with some rows changed and others added; this one is not changed. Unchanged chunks are shared, so a small edit of a large drawing
    /// costs little memory and time.</summary>
    public GrowingColumn<T> With(IEnumerable<(int Index, T Value)> changes, IEnumerable<T> added)
    {
        ArgumentNullException.ThrowIfNull(changes);
        ArgumentNullException.ThrowIfNull(added);
        var edited = new GrowingColumn<T> { Count = Count };
        edited._chunks.AddRange(_chunks);
        var owned = new HashSet<int>();
        foreach (var (index, value) in changes)
        {
            if ((uint)index >= (uint)Count) throw new ArgumentOutOfRangeException(nameof(changes));
            edited.Own(index >> ChunkShift, owned);
            edited[index] = value;
        }

        if (_chunks.Count > 0) edited.Own(_chunks.Count - 1, owned);
        edited._last = edited._chunks.Count > 0 ? edited._chunks[^1] : [];
        foreach (var value in added) edited.Add(value);
        return edited;
    }

    /// <summary>True when another column has as many rows and each is the same.</summary>
    public bool HasRowsOf(GrowingColumn<T> other, RowComparison same)
    {
        ArgumentNullException.ThrowIfNull(other);
        ArgumentNullException.ThrowIfNull(same);
        if (other.Count != Count) return false;
        for (var row = 0; row < Count; row++)
        {
            if (!same(this[row], other[row])) return false;
        }

        return true;
    }

    /// <summary>Compares two rows.</summary>
    public delegate bool RowComparison(in T one, in T other);

    private void Own(int chunk, HashSet<int> owned)
    {
        if (owned.Add(chunk)) _chunks[chunk] = [.. _chunks[chunk]];
    }
}
