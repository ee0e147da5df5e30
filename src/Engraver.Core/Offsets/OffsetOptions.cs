namespace Engraver.Core.Offsets;

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
