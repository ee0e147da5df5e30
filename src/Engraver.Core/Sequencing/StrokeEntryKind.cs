namespace Engraver.Core.Sequencing;

/// <summary>How a contour is begun.</summary>
public enum StrokeEntryKind : byte
{
    /// <summary>At the start of a piece, in the contour's own direction (circles: at the right quadrant point).</summary>
    Forward,

    /// <summary>At the end of an open contour, every piece reversed.</summary>
    Turned,

    /// <summary>At a circle's left quadrant point, in the drawn direction.</summary>
    LeftQuadrant,
}
