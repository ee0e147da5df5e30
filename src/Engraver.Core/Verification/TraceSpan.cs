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

    /// <summary>Outputs during the span, as in <see cref="TraceSample.Outputs"/>.</summary>
    public int? Outputs { get; init; }

    internal TraceSample At(double fraction)
    {
        var place = Path.PointAt(fraction);
        return new TraceSample(FromSeconds + ((ToSeconds - FromSeconds) * fraction), place.X, place.Y, Cutting) { FollowingMm = FollowingMm, Outputs = Outputs };
    }
}
