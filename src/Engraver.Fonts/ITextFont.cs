namespace Engraver.Fonts;

/// <summary>A font whose characters are curves: outlines that bound areas, or strokes that the tool follows.</summary>
public interface ITextFont
{
    /// <summary>As the font names itself.</summary>
    string Name { get; }

    /// <summary>True: contours are closed and bound areas, to be filled by the non-zero rule. False: contours are strokes of the tool, open or
    /// closed.</summary>
    bool IsOutline { get; }

    FontMetrics Metrics { get; }

    bool Contains(int codePoint);

    /// <returns>Null if the font has no such character.</returns>
    /// <exception cref="BrokenFontException">The font file has impossible content for this character.</exception>
    GlyphCurves? GlyphOf(int codePoint);

    /// <summary>Font units to add to the advance of the left character when the right one follows it; 0 if the font has none for the pair.</summary>
    double KerningOf(int left, int right);
}
