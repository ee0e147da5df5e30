namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Memory to draw into: premultiplied pixels for the device pixels of <see cref="Bounds"/>. The owner keeps the memory alive.</summary>
internal readonly unsafe struct PixelSurface(uint* pixels, int pixelsPerRow, PixelBounds bounds)
{
    public PixelBounds Bounds { get; } = bounds;

    /// <summary>Part of a device row; the caller stays within <see cref="Bounds"/>.</summary>
    public Span<uint> Row(int y, int left, int right) =>
        new(pixels + (long)(y - Bounds.Top) * pixelsPerRow + (left - Bounds.Left), right - left);
}
