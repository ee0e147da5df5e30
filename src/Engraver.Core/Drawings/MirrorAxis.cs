namespace Engraver.Core.Drawings;

/// <summary>The axis about which a drawing is mirrored.</summary>
public enum MirrorAxis
{
    None,

    /// <summary>About the X axis: Y changes its sign, top and bottom are exchanged.</summary>
    X,

    /// <summary>About the Y axis: X changes its sign, left and right are exchanged.</summary>
    Y,
}
