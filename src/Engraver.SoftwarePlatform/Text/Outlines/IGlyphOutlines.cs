using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Text.Outlines;

/// <summary>The shapes of a face's glyphs.</summary>
internal interface IGlyphOutlines
{
    /// <summary>In font units, y up, to be filled by the non-zero rule. Empty for a blank or unknown glyph.</summary>
    /// <exception cref="BrokenFontException">The glyph's description is invalid.</exception>
    VectorPath Outline(int glyph);
}
