namespace Engraver.Core.TextMarkup;

/// <summary>The pieces up to the next \P.</summary>
public sealed record MTextParagraph(ParagraphFormat Format, IReadOnlyList<MTextPiece> Pieces);
