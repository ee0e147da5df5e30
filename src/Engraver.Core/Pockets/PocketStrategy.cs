namespace Engraver.Core.Pockets;

/// <summary>Strategy for cutting the inside of a pocket.</summary>
public enum PocketStrategy
{
    /// <summary>Passes parallel to the walls.</summary>
    Contour,

    /// <summary>Straight rows back and forth, and a pass along the walls.</summary>
    Zigzag,
}
