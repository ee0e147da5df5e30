namespace Engraver.Fonts;

/// <summary>Heights of a font, in font units, y up.</summary>
/// <param name="CapHeight">From the baseline to the top of a flat capital letter; the text height of a drawing is this height.</param>
/// <param name="Descent">Positive below the baseline.</param>
/// <param name="LineSpacing">From one baseline to the next.</param>
public readonly record struct FontMetrics(double UnitsPerEm, double CapHeight, double Ascent, double Descent, double LineSpacing);
