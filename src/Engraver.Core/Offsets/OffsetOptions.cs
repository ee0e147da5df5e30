namespace Engraver.Core.Offsets;

/// <summary>On which side of its contours an offset runs.</summary>
/// <remarks>Left and right are those of the drawn direction, and every contour is offset by itself. In and out look at all closed contours together: what lies inside an odd number of
/// them is material (islands are holes in it), which becomes smaller or larger.</remarks>
public enum OffsetSide
{
    Left,
    Right,
    In,
    Out,

    /// <summary>In and out of closed contours, left and right of open ones.</summary>
    Both,
}

/// <summary>How an offset goes round the outside of a corner.</summary>
public enum OffsetJoin
{
    /// <summary>An arc about the corner: every point of the offset has the exact distance.</summary>
    Round,

    /// <summary>Both sides go on straight until they meet; a bevel where they would meet too far away.</summary>
    Mitre,

    /// <summary>A straight line from side to side, nearer to the corner than the distance.</summary>
    Bevel,
}

/// <summary>The choices of an offset besides distance and side.</summary>
public sealed record OffsetOptions
{
    public static OffsetOptions Default { get; } = new();

    public OffsetJoin Join { get; init; } = OffsetJoin.Round;

    /// <summary>Farthest tip of a mitre from its corner, as a multiple of the distance; at least 1.</summary>
    public double MitreLimit { get; init; } = 4.0;

    /// <summary>Largest distance of the arcs that stand for an ellipse or spline, millimetres.</summary>
    public double MaxErrorMm { get; init; } = 0.001;
}
