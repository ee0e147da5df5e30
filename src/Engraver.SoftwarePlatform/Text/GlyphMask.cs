using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Coverage of a glyph around its origin.</summary>
internal sealed class GlyphMask(PixelBounds bounds, byte[] cells)
{
    public PixelBounds Bounds => bounds;

    public int Bytes => cells.Length;

    public ReadOnlySpan<byte> Row(int y) => cells.AsSpan((y - bounds.Top) * bounds.Width, bounds.Width);
}
