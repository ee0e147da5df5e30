namespace Engraver.Core.TextMarkup;

/// <summary>Place across the line (\A).</summary>
public enum LineAlignment : byte
{
    Bottom,
    Centre,
    Top,
}
