namespace Engraver.Core.Drawings;

/// <summary>Position of the reference point across the text's line (group 73 of TEXT).</summary>
public enum TextRowAlignment
{
    Baseline,
    Bottom,
    Middle,
    Top,
}
