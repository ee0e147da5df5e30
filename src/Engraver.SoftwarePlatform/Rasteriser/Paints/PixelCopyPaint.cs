namespace Engraver.SoftwarePlatform.Rasteriser.Paints;

/// <summary>An image copied pixel by pixel, its first pixel at the given device pixel. Only called for pixels that the image has.</summary>
internal sealed class PixelCopyPaint(PixelSource source, int left, int top, uint opacity) : Paint
{
    public override bool IsOpaque => source.IsOpaque && opacity == 255;

    public override void Shade(int x, int y, Span<uint> row)
    {
        source.Row(y - top, x - left, x - left + row.Length).CopyTo(row);
        if (source.IsOpaque)
        {
            for (var i = 0; i < row.Length; i++)
                row[i] |= source.AlphaFill;
        }
        PixelRows.Scale(row, opacity);
    }
}

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
