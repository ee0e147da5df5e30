namespace Engraver.Core.TextMarkup;

/// <summary>A place in a line to which a tab moves.</summary>
/// <param name="Position">From the left side of the frame, as a multiple of the height of the entity.</param>
/// <param name="Alignment">Left, Centre or Right of the text at the tab stop.</param>
public readonly record struct TabStop(double Position, ParagraphAlignment Alignment);
