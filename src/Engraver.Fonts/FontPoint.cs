namespace Engraver.Fonts;

/// <summary>A point in font units, y up, relative to the origin of the glyph on the baseline.</summary>
public readonly record struct FontPoint(double X, double Y);
