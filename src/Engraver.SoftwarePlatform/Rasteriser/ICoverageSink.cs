namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Takes the coverage of a filled shape, row by row from the top, left to right, without overlaps. 255 is fully covered.</summary>
internal interface ICoverageSink
{
    /// <summary>Equal coverage from <paramref name="left"/> up to, not including, <paramref name="right"/>.</summary>
    void Run(int y, int left, int right, byte coverage);

    /// <summary>One coverage per pixel from <paramref name="left"/> on.</summary>
    void Cells(int y, int left, ReadOnlySpan<byte> coverages);
}
