using Engraver.Core.Geometry;

namespace Engraver.Core.Motion;

/// <summary>A move from rest to rest.</summary>
/// <param name="Seconds">Duration of the motion.</param>
/// <param name="Wait">Duration of the rest before it, seconds.</param>
/// <param name="End">Where it comes to rest, drawing millimetres.</param>
public readonly record struct ScheduledMove(double Seconds, double Wait, Point2D End)
{
    /// <summary>Number of segments that are loaded for it; 0 for a rapid.</summary>
    public int Segments { get; init; }
}
