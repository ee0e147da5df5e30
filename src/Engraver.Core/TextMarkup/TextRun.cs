namespace Engraver.Core.TextMarkup;

/// <summary>Characters with the same marks.</summary>
/// <param name="Text">UTF-16, without codes; a tab is a character of it.</param>
/// <param name="Marks">The lines drawn with them.</param>
public readonly record struct TextRun(string Text, LineMarks Marks);
