using System.Buffers;

namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>One coverage byte for each pixel of a rectangle. Its memory comes from the shared pool and must not be read after disposal.</summary>
internal sealed class CoverageMask : IDisposable
{
    private byte[]? _cells;

    public CoverageMask(PixelBounds bounds)
    {
        Bounds = bounds;
        _cells = ArrayPool<byte>.Shared.Rent(Math.Max(1, bounds.Width * bounds.Height));
        _cells.AsSpan(0, bounds.Width * bounds.Height).Clear();
    }

    public PixelBounds Bounds { get; }

    public Span<byte> Cells => (_cells ?? throw new ObjectDisposedException(nameof(CoverageMask))).AsSpan(0, Bounds.Width * Bounds.Height);

    public Span<byte> Row(int y, int left, int right) => Cells.Slice((y - Bounds.Top) * Bounds.Width + left - Bounds.Left, right - left);

    public void Dispose()
    {
        if (_cells is null)
            return;
        ArrayPool<byte>.Shared.Return(_cells);
        _cells = null;
    }
}
