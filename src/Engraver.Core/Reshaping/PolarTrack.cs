using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>Polar tracking: a place that is nearly in one of the tracking directions from another place is moved onto it.</summary>
public static class PolarTrack
{
    /// <param name="from">The previous point.</param>
    /// <param name="place">The cursor position.</param>
    /// <param name="step">The tracking directions are multiples of this angle, degrees, above 0.</param>
    /// <param name="reach">Largest distance of the place from the direction.</param>
    /// <returns>The foot on the direction; null when the place is too far from it, or at the previous point.</returns>
    public static Point2D? Find(Point2D from, Point2D place, double step, double reach)
    {
        var offset = place - from;
        if (offset == default || !(step > 0.0)) return null;
        var direction = Vector2D.FromPolar(1.0, Angle.FromDegrees(Math.Round(offset.Direction.Degrees / step) * step));
        var along = offset.Dot(direction);
        return along > 0.0 && Math.Abs(offset.Cross(direction)) <= reach ? from + (direction * along) : null;
    }
}
