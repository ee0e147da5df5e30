using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Machine position at one time, from its record; drawing coordinates in millimetres.</summary>
/// <param name="Seconds">Time of the sample.</param>
/// <param name="XMm">Drawing X.</param>
/// <param name="YMm">Drawing Y.</param>
/// <param name="Cutting">True when the tool is cutting: its output is on, or its height is below the retract height.</param>
/// <param name="ZMm">Height above the drawing's height 0; 0 on a machine without a tool axis.</param>
public readonly record struct TraceSample(double Seconds, double XMm, double YMm, bool Cutting, double ZMm = 0.0)
{
    /// <summary>Following error: distance of the motors from their commanded positions in X and Y, millimetres; null when not recorded.</summary>
    public double? FollowingMm { get; init; }

    /// <summary>Outputs 1 to 8 of the controller, bit 0 is output 1; null where they were not recorded.</summary>
    public int? Outputs { get; init; }

    public Point2D Place => new(XMm, YMm);
}
