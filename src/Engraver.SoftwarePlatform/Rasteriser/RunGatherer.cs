namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Gathers the short pieces of one row, so that the fillers are called for a few long spans instead of single pixels.</summary>
internal ref struct RunGatherer<TSink>(Span<byte> cells, int y, int origin)
    where TSink : struct, ICoverageSink
{
    /// <summary>Equal coverage at least this long is given as a run of its own.</summary>
    private const int MinRunLength = 16;

    private readonly Span<byte> _cells = cells;
    private int _start;
    private int _count;

    /// <summary>Cells from <paramref name="left"/> to <paramref name="right"/>, counted from the row's origin; each call continues where the last one
    /// ended.</summary>
    public void Add(ref TSink sink, int left, int right, byte coverage)
    {
        if (right <= left)
            return;
        var isShort = right - left < MinRunLength;
        if (coverage == 0 || !isShort)
            Flush(ref sink);
        if (coverage == 0)
            return;
        if (!isShort)
        {
            sink.Run(y, origin + left, origin + right, coverage);
            return;
        }
        if (_count == 0)
            _start = left;
        _cells.Slice(_count, right - left).Fill(coverage);
        _count += right - left;
    }

    public void Flush(ref TSink sink)
    {
        if (_count > 0)
            sink.Cells(y, origin + _start, _cells[.._count]);
        _count = 0;
    }
}
