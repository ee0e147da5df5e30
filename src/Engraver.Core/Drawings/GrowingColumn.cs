using System.Runtime.CompilerServices;

namespace Engraver.Core.Drawings;

/// <summary>A column of values that grows in chunks: appending never copies what is there, so a million rows cost their own size and no more.</summary>
public sealed class GrowingColumn<T>
    where T : struct
{
    private const int ChunkShift = 12;
    private const int ChunkSize = 1 << ChunkShift;
    private readonly List<T[]> _chunks = [];

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
        if ((Count & (ChunkSize - 1)) == 0) _chunks.Add(GC.AllocateUninitializedArray<T>(ChunkSize));
        _chunks[Count >> ChunkShift][Count & (ChunkSize - 1)] = value;
        return Count++;
    }
}
