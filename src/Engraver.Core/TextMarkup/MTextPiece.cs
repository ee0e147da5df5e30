namespace Engraver.Core.TextMarkup;

/// <summary>Characters of one format, or what is between them.</summary>
/// <param name="Kind">Characters, a stack, or a break.</param>
/// <param name="Text">Of <see cref="MTextPieceKind.Text"/>: UTF-16 without codes; "" for other kinds.</param>
/// <param name="Format">The format at this place.</param>
/// <param name="Stack">Of <see cref="MTextPieceKind.Stack"/>, otherwise null.</param>
public sealed record MTextPiece(MTextPieceKind Kind, string Text, MTextFormat Format, MTextStack? Stack = null);
