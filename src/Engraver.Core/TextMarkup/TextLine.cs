namespace Engraver.Core.TextMarkup;

/// <summary>The characters of a TEXT, ATTRIB or ATTDEF.</summary>
/// <param name="Runs">In reading order; none for an empty text. Neighbours have different marks.</param>
/// <param name="UnknownCodes">Codes that have no meaning or no character, each once, at most 100.</param>
public sealed record TextLine(IReadOnlyList<TextRun> Runs, IReadOnlyList<string> UnknownCodes);
