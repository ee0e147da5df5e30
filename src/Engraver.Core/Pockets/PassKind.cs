namespace Engraver.Core.Pockets;

/// <summary>Purpose of a pass.</summary>
public enum PassKind
{
    /// <summary>At the tool's radius (and the allowance) from the wall.</summary>
    Wall,

    /// <summary>Parallel to the wall, further in.</summary>
    Contour,

    /// <summary>Between two passes that leave a sliver: in a corner, or along the middle.</summary>
    Sliver,

    /// <summary>A straight row of a zigzag.</summary>
    Row,

    /// <summary>Along the wall, after all other passes, removing the allowance.</summary>
    Finish,
}
