namespace Engraver.Fonts;

/// <summary>Pieces that follow each other, each from the end of the one before.</summary>
/// <param name="Pieces">At least one.</param>
/// <param name="IsClosed">The last piece ends exactly at <paramref name="Start"/>: the line that closes an outline is a piece as the others.</param>
public sealed record GlyphContour(FontPoint Start, IReadOnlyList<GlyphPiece> Pieces, bool IsClosed);
