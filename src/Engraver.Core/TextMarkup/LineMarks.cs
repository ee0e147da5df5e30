namespace Engraver.Core.TextMarkup;

/// <summary>Lines that are drawn with characters.</summary>
[Flags]
public enum LineMarks : byte
{
    None = 0,
    Underline = 1,
    Overline = 2,
    StrikeThrough = 4,
}
