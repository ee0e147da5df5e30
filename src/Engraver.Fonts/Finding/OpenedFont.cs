namespace Engraver.Fonts.Finding;

/// <summary>A font with the hash of what it was read from.</summary>
/// <param name="Path">Null for a font of the program.</param>
internal sealed record OpenedFont(ITextFont Font, string? Path, string Sha256);
