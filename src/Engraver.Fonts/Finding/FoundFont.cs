namespace Engraver.Fonts.Finding;

/// <param name="Path">Of the file; null for a font of the program.</param>
/// <param name="Sha256">Hexadecimal, of the bytes of the file or of the data of the font of the program.</param>
public sealed record FoundFont(ITextFont Font, FontRequest Request, FontMatch Match, FontTrouble Trouble, string? Path, string Sha256);
