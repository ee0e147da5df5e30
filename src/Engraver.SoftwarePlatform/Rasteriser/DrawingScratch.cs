using System.Collections.Concurrent;
using Engraver.SoftwarePlatform.Rasteriser.Paths;
using Engraver.SoftwarePlatform.Rasteriser.Shadows;

namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Buffers that one drawing context at a time uses; kept when it ends, for the next one.</summary>
internal sealed class DrawingScratch
{
    public const int LongestSpan = 4096;

    private static readonly ConcurrentBag<DrawingScratch> s_free = [];

    private DrawingScratch()
    {
    }

    public CoverageAccumulator Accumulator { get; } = new();

    public VectorPath Path { get; } = new();

    public uint[] Shaded { get; } = new uint[LongestSpan];

    public byte[] Covered { get; } = new byte[LongestSpan];

    public ShadowMasks Shadows { get; } = new();

    public static DrawingScratch Take() => s_free.TryTake(out var kept) ? kept : new DrawingScratch();

    public void GiveBack() => s_free.Add(this);
}
