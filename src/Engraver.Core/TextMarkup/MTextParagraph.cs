namespace Engraver.Core.TextMarkup;

/// <summary>The pieces up to the next \P.</summary>
/// <param name="End">The format at its end: that of the letters which a paragraph without pieces would have.</param>
public sealed record MTextParagraph(ParagraphFormat Format, IReadOnlyList<MTextPiece> Pieces, MTextFormat End);
