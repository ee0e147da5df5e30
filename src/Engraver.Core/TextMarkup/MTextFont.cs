namespace Engraver.Core.TextMarkup;

/// <summary>A font that a text names (\f, \F).</summary>
/// <param name="Name">Family of a TrueType font, or file of a stroke font (SHX).</param>
/// <param name="BigFont">File of the Asian characters of a stroke font; "" for none.</param>
/// <param name="IsBold">b1.</param>
/// <param name="IsItalic">i1.</param>
/// <param name="CharacterSet">c: the number of a Windows character set.</param>
/// <param name="Pitch">p: pitch and family as Windows states them.</param>
/// <param name="IsShape">True for a stroke font: the name ends with .shx, or the code (\F) states neither b nor i.</param>
public sealed record MTextFont(string Name, string BigFont, bool IsBold, bool IsItalic, int CharacterSet, int Pitch, bool IsShape);
