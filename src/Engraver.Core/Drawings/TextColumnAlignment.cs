namespace Engraver.Core.Drawings;

/// <summary>Position of the reference point along the text's line (group 72 of TEXT).</summary>
public enum TextColumnAlignment
{
    Left,
    Centre,
    Right,

    /// <summary>From the position to the end point; the height follows from the width.</summary>
    Aligned,

    /// <summary>In the middle of the text, along and across.</summary>
    Middle,

    /// <summary>From the position to the end point at the given height; the width factor follows.</summary>
    Fit,
}
