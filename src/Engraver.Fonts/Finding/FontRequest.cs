namespace Engraver.Fonts.Finding;

/// <summary>The font that a style or a format code of a text names.</summary>
/// <param name="File">Name of the font file, with or without its folder and its extension; empty if only the family is stated.</param>
/// <param name="Family">As installed outline fonts name themselves; empty if only the file is stated.</param>
public sealed record FontRequest(string File, string Family, bool IsBold, bool IsItalic);
