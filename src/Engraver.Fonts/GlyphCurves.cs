namespace Engraver.Fonts;

/// <summary>The shape of a character and its width.</summary>
/// <param name="Advance">From its origin to that of the next character, in font units.</param>
/// <param name="Contours">Empty for a space.</param>
public sealed record GlyphCurves(double Advance, IReadOnlyList<GlyphContour> Contours);
