namespace Engraver.Fonts.OpenType;

/// <summary>The widths and left edges of glyphs (OpenType 1.9, hmtx).</summary>
internal sealed class HorizontalMetrics
{
    private readonly FontBytes _table;
    private readonly int _count;

    /// <exception cref="BrokenFontException">There are no widths.</exception>
    public HorizontalMetrics(FontFile file)
    {
        _table = file.Table("hmtx");
        _count = file.Table("hhea").UInt16(34);
        if (_count == 0)
            throw new BrokenFontException("The font has no widths.");
    }

    /// <summary>From the origin to the left edge of the outline. Glyphs after the last width have a list of their own.</summary>
    public int LeftOf(int glyph) => _table.Int16(glyph < _count ? 4 * glyph + 2 : 4 * _count + 2 * (glyph - _count));

    /// <summary>Glyphs after the last width have that width.</summary>
    public int AdvanceOf(int glyph) => _table.UInt16(4 * Math.Min(glyph, _count - 1));
}
