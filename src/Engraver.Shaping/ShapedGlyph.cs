namespace Engraver.Shaping;

/// <summary>A glyph of a font at its place in a line, in font units, y up.</summary>
/// <param name="Glyph">Its number in the font; 0 if the font has no such character.</param>
/// <param name="Cluster">Index of the first UTF-16 unit that it stands for.</param>
/// <param name="Advance">To the origin of the next glyph.</param>
/// <param name="XOffset">From its place in the line to its origin.</param>
public readonly record struct ShapedGlyph(int Glyph, int Cluster, double Advance, double XOffset, double YOffset);
