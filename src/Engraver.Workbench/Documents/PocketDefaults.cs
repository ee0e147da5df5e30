using Engraver.Core.Pockets;

namespace Engraver.Workbench.Documents;

/// <summary>The defaults of a pocket, for the command POCKET and for <c>engraver pocket</c>. Lengths in millimetres.</summary>
public static class PocketDefaults
{
    public const double ToolDiameter = 1.0;

    /// <summary>As a fraction of the tool's diameter.</summary>
    public const double Stepover = 0.5;

    public const PocketStrategy Strategy = PocketStrategy.Contour;

    /// <summary>Direction of the rows of <see cref="PocketStrategy.Zigzag"/>, degrees.</summary>
    public const double AngleDegrees = 0.0;

    /// <summary>False: contour-parallel passes start at the wall.</summary>
    public static bool FromCentre => false;

    public const double Allowance = 0.0;

    /// <summary>0: the machine profile sets the cutting depth.</summary>
    public const double Depth = 0.0;

    /// <summary>0: one level.</summary>
    public const double Step = 0.0;

    public const PocketEntry Entry = PocketEntry.Plunge;

    /// <summary>Angle of descent of a ramp or helix, degrees.</summary>
    public const double RampAngleDegrees = 3.0;
}
