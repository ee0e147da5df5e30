namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Rounds coverage to whole pixels: covered by half or more, or not at all.</summary>
internal readonly struct ThresholdSink<TSink>(TSink sink) : ICoverageSink
    where TSink : struct, ICoverageSink
{
    private const byte Half = 128;

    public void Run(int y, int left, int right, byte coverage)
    {
        if (coverage >= Half)
            sink.Run(y, left, right, 255);
    }

    public void Cells(int y, int left, ReadOnlySpan<byte> coverages)
    {
        for (var i = 0; i < coverages.Length; i++)
        {
            if (coverages[i] >= Half)
                sink.Run(y, left + i, left + i + 1, 255);
        }
    }
}
