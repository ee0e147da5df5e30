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

/// <summary>Shape of an offset at the outside of a corner.</summary>
public enum OffsetJoin
{
    /// <summary>An arc about the corner: every point of the offset has the exact distance.</summary>
    Round,

    /// <summary>Both sides are extended straight until they meet; a bevel when they would meet beyond the limit.</summary>
    Mitre,

    /// <summary>A straight line from side to side, nearer to the corner than the distance.</summary>
    Bevel,
}

/// <summary>Options of an offset other than distance and side.</summary>
public sealed record OffsetOptions
{
    public required OffsetJoin Join { get; init; }

    /// <summary>Maximum distance of the tip of a mitre from its corner, as a multiple of the distance; at least 1. Not used by other joins.</summary>
    public required double MitreLimit { get; init; }

    /// <summary>Largest distance of the arcs that approximate an ellipse or spline, millimetres.</summary>
    public required double MaxErrorMm { get; init; }

    /// <summary>Round corners: every point of the offset has the exact distance.</summary>
    /// <param name="maxErrorMm">Largest distance of the arcs that approximate an ellipse or spline, millimetres.</param>
    public static OffsetOptions Round(double maxErrorMm) => new() { Join = OffsetJoin.Round, MitreLimit = 1.0, MaxErrorMm = maxErrorMm };
}
