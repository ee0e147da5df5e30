namespace Engraver.Core.Offsets;

/// <summary>Side of its contours on which an offset runs.</summary>
/// <remarks>Left and right refer to the drawn direction, and every contour is offset separately. In and out refer to all closed contours together: the area
/// inside an odd number of them is material (islands are holes in it), which becomes smaller or larger.</remarks>
public enum OffsetSide
{
    Left,
    Right,
    In,
    Out,

    /// <summary>In and out of closed contours, left and right of open ones.</summary>
    Both,
}
