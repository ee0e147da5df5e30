namespace Engraver.Simulator;

/// <summary>Rows of a record: single rows in chunks, so that hours of motion need no copying and do not fragment memory, and spans of constant speed between
/// them.</summary>
internal sealed class RowStore
{
    private const int ChunkSize = 1 << 12;
    private readonly List<MotionSample[]> _chunks = [];
    private readonly List<(long FirstRow, long SinglesBefore, MotionSpan Span)> _spans = [];
    private long _singles;

    /// <summary>Number of rows, including those within spans.</summary>
    public long Count { get; private set; }

    /// <summary>Returns a row by its number.</summary>
    public MotionSample this[long row]
    {
        get
        {
            var place = LastSpanAt(row);
            if (place < 0) return Single(row);
            var (first, singlesBefore, span) = _spans[place];
            return row - first < span.Count ? span[row - first] : Single(singlesBefore + row - first - span.Count);
        }
    }

    public void Add(in MotionSample row)
    {
        if (_singles == (long)_chunks.Count * ChunkSize) _chunks.Add(new MotionSample[ChunkSize]);
        _chunks[(int)(_singles / ChunkSize)][_singles % ChunkSize] = row;
        _singles++;
        Count++;
    }

    public void Add(MotionSpan span)
    {
        _spans.Add((Count, _singles, span));
        Count += span.Count;
    }

    /// <summary>All rows from this number on.</summary>
    public IEnumerable<MotionSample> From(long row)
    {
        for (; row < Count; row++) yield return this[row];
    }

    /// <summary>All rows in order, each span as one part.</summary>
    public IEnumerable<RecordPart> Parts()
    {
        var single = 0L;
        foreach (var (_, singlesBefore, span) in _spans)
        {
            for (; single < singlesBefore; single++) yield return new RecordPart(Single(single), null);
            yield return new RecordPart(span.Last, span);
        }

        for (; single < _singles; single++) yield return new RecordPart(Single(single), null);
    }

    private MotionSample Single(long index) => _chunks[(int)(index / ChunkSize)][index % ChunkSize];

    /// <summary>Index of the last span that begins at or before a row; -1 when there is none.</summary>
    private int LastSpanAt(long row)
    {
        var (low, high) = (0, _spans.Count);
        while (low < high)
        {
            var middle = (low + high) / 2;
            if (_spans[middle].FirstRow <= row) low = middle + 1;
            else high = middle;
        }

        return low - 1;
    }

    /// <summary>A row, or a span in place of it.</summary>
    public readonly record struct RecordPart(MotionSample Row, MotionSpan? Span);
}
