namespace Engraver.Core.Drawings;

/// <summary>Where the reference point of a text lies across its line (group 73 of TEXT).</summary>
public enum TextRowAlignment
{
    Baseline,
    Bottom,
    Middle,
    Top,
}
