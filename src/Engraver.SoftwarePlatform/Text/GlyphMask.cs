using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Coverage of a glyph around its origin. Rows end with uncovered cells, so that their length is a multiple of <see cref="PixelRows.Lane"/>.</summary>
internal sealed class GlyphMask
{
    private readonly byte[] _cells;

    /// <param name="cells">Row by row, without the added cells.</param>
    public GlyphMask(PixelBounds bounds, ReadOnlySpan<byte> cells)
    {
        Bounds = bounds;
        Stride = (bounds.Width + PixelRows.Lane - 1) / PixelRows.Lane * PixelRows.Lane;
        _cells = new byte[Stride * bounds.Height];
        for (var y = 0; y < bounds.Height; y++)
            cells.Slice(y * bounds.Width, bounds.Width).CopyTo(_cells.AsSpan(y * Stride));
    }

    /// <summary>A glyph without ink.</summary>
    public static GlyphMask Blank { get; } = new(default, []);

    public PixelBounds Bounds { get; }

    /// <summary>Cells of a row, including the added ones.</summary>
    public int Stride { get; }

    /// <summary>All rows, including the added cells.</summary>
    public ReadOnlySpan<byte> Cells => _cells;

    /// <summary>Without the added cells.</summary>
    public ReadOnlySpan<byte> Row(int y) => _cells.AsSpan((y - Bounds.Top) * Stride, Bounds.Width);
}
