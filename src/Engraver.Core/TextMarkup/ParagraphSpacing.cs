namespace Engraver.Core.TextMarkup;

/// <summary>The line distance of a paragraph.</summary>
public enum ParagraphSpacing : byte
{
    Default,
    Exactly,
    AtLeast,
    Multiple,
}
