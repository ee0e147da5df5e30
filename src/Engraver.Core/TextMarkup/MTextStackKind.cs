namespace Engraver.Core.TextMarkup;

/// <summary>How the two texts of a stack are separated.</summary>
public enum MTextStackKind : byte
{
    /// <summary>^ : no line.</summary>
    Tolerance,

    /// <summary>/ : a horizontal line.</summary>
    Horizontal,

    /// <summary># : a diagonal line.</summary>
    Diagonal,
}
