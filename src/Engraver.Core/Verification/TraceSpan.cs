using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Where the machine was during many samples that follow from one another: along a line, or an arc of at most half a turn, at constant speed.</summary>
/// <param name="FromSeconds">Time of the first sample.</param>
/// <param name="ToSeconds">Time of the last sample.</param>
/// <param name="Samples">How many they are.</param>
/// <param name="Path">From the first to the last, drawing coordinates in millimetres; a line or an arc.</param>
/// <param name="Cutting">True while the tool output is on, the whole time.</param>
public readonly record struct TraceSpan(double FromSeconds, double ToSeconds, long Samples, Segment Path, bool Cutting)
{
    internal TraceSample At(double fraction)
    {
        var place = Path.PointAt(fraction);
        return new TraceSample(FromSeconds + ((ToSeconds - FromSeconds) * fraction), place.X, place.Y, Cutting);
    }
}
