using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Motion of the machine over many samples at constant speed: along a line, or an arc of at most half a turn.</summary>
/// <param name="FromSeconds">Time of the first sample.</param>
/// <param name="ToSeconds">Time of the last sample.</param>
/// <param name="Samples">Number of samples.</param>
/// <param name="Path">Path from the first to the last sample, drawing coordinates in millimetres; a line or an arc.</param>
/// <param name="Cutting">True when the tool output is on during the whole span.</param>
public readonly record struct TraceSpan(double FromSeconds, double ToSeconds, long Samples, Segment Path, bool Cutting)
{
    /// <summary>Following error of every sample, as in <see cref="TraceSample.FollowingMm"/>.</summary>
    public double? FollowingMm { get; init; }

    internal TraceSample At(double fraction)
    {
        var place = Path.PointAt(fraction);
        return new TraceSample(FromSeconds + ((ToSeconds - FromSeconds) * fraction), place.X, place.Y, Cutting) { FollowingMm = FollowingMm };
    }
}

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

    public Point2D Place => new(XMm, YMm);
}
