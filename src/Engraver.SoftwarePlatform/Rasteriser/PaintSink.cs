namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Paints coverage as it comes.</summary>
internal readonly struct PaintSink(SurfacePainter painter, Paint paint, ClipShape clip) : ICoverageSink
{
    public void Run(int y, int left, int right, byte coverage) => painter.Run(y, left, right, coverage, paint, clip);

    public void Cells(int y, int left, ReadOnlySpan<byte> coverages) => painter.Cells(y, left, coverages, paint, clip);
}
