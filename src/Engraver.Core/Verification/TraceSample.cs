using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Where the machine was at one moment, as its record says; drawing coordinates in millimetres.</summary>
/// <param name="Seconds">Time of the sample.</param>
/// <param name="XMm">Drawing X.</param>
/// <param name="YMm">Drawing Y.</param>
/// <param name="Cutting">True while the tool output is on.</param>
public readonly record struct TraceSample(double Seconds, double XMm, double YMm, bool Cutting)
{
    public Point2D Place => new(XMm, YMm);
}
