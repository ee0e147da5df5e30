namespace Engraver.SoftwarePlatform.Rasteriser.Paints;

/// <summary>Pixels to read: premultiplied, or with an alpha byte that counts as 255 where <paramref name="alphaFill"/> is 0xFF000000.</summary>
internal readonly unsafe struct PixelSource(uint* pixels, int pixelsPerRow, int width, int height, uint alphaFill)
{
    public int Width => width;

    public int Height => height;

    public bool IsOpaque => AlphaFill != 0;

    public uint AlphaFill => alphaFill;

    public uint this[int x, int y] => pixels[(long)y * pixelsPerRow + x] | alphaFill;

    /// <summary>Raw pixels, without <see cref="AlphaFill"/>.</summary>
    public ReadOnlySpan<uint> Row(int y, int left, int right) => new(pixels + (long)y * pixelsPerRow + left, right - left);
}
