namespace Engraver.Core.TextMarkup;

/// <summary>The content of an MTEXT.</summary>
/// <param name="Paragraphs">At least one; the last may be empty.</param>
/// <param name="UnknownCodes">Codes that have no meaning or no valid value, and fields without a value in the file; each once, at most 100.</param>
public sealed record MTextContent(IReadOnlyList<MTextParagraph> Paragraphs, IReadOnlyList<string> UnknownCodes);
