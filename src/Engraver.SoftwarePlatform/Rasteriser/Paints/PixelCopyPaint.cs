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
