namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Writes coverage into a mask that holds at least the bounds of the shape.</summary>
internal readonly struct MaskSink(CoverageMask mask) : ICoverageSink
{
    public void Run(int y, int left, int right, byte coverage) => mask.Row(y, left, right).Fill(coverage);

    public void Cells(int y, int left, ReadOnlySpan<byte> coverages) => coverages.CopyTo(mask.Row(y, left, left + coverages.Length));
}
