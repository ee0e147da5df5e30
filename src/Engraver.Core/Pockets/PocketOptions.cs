using Engraver.Core.Geometry;

namespace Engraver.Core.Pockets;

/// <summary>Tool and strategy of a pocket. Lengths in millimetres.</summary>
public sealed record PocketOptions
{
    /// <summary>Radius of the tool, above 0.</summary>
    public required double ToolRadius { get; init; }

    /// <summary>Distance of neighbouring passes as a fraction of the tool's diameter (F), above 0 and below 1.</summary>
    public required double Stepover { get; init; }

    public required PocketStrategy Strategy { get; init; }

    /// <summary>Direction of the rows of <see cref="PocketStrategy.Zigzag"/>, counter-clockwise from the X axis.</summary>
    public required Angle Angle { get; init; }

    /// <summary>True when contour-parallel passes start in the middle and end at the wall; otherwise they start at the wall.</summary>
    public required bool FromCentre { get; init; }

    /// <summary>Allowance that the passes leave at the walls, for a last pass along them; 0 to the radius, 0 for no such pass.</summary>
    public required double Allowance { get; init; }

    /// <summary>Largest distance of the arcs that approximate an ellipse or spline.</summary>
    public required double MaxErrorMm { get; init; }

    /// <summary>Distance within which drawn ends were joined.</summary>
    public required double JoinToleranceMm { get; init; }

    /// <summary>Distance of neighbouring passes: 2 R F.</summary>
    public double PassDistance => 2.0 * ToolRadius * Stepover;

    /// <summary>Width that is swept by both of two neighbouring passes: 2 R (1 - F).</summary>
    public double PassOverlap => 2.0 * ToolRadius * (1.0 - Stepover);
}
