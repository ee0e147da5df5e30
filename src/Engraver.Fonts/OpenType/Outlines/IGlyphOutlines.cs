namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>The shapes of a face's glyphs.</summary>
public interface IGlyphOutlines
{
    /// <summary>Draws the contours of a glyph, to be filled by the non-zero rule; none for a blank or unknown glyph.</summary>
    /// <exception cref="BrokenFontException">The glyph's description is invalid. The sink may have received a part of it.</exception>
    void Draw(int glyph, IOutlineSink sink);

    /// <summary>The left edge that the glyph's description states; null if the format has none or the glyph is blank.</summary>
    int? StatedLeft(int glyph);
}
