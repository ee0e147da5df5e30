using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>Polar tracking: a place that is nearly in one of the wanted directions from another is moved into it.</summary>
public static class PolarTrack
{
    /// <param name="from">The point before.</param>
    /// <param name="place">Where the cursor is.</param>
    /// <param name="step">The wanted directions are multiples of this angle, degrees, above 0.</param>
    /// <param name="reach">How far the place may lie beside the direction.</param>
    /// <returns>The foot on the direction; null when the place lies too far beside it, or on the point before.</returns>
    public static Point2D? Find(Point2D from, Point2D place, double step, double reach)
    {
        var offset = place - from;
        if (offset == default || !(step > 0.0)) return null;
        var direction = Vector2D.FromPolar(1.0, Angle.FromDegrees(Math.Round(offset.Direction.Degrees / step) * step));
        var along = offset.Dot(direction);
        return along > 0.0 && Math.Abs(offset.Cross(direction)) <= reach ? from + (direction * along) : null;
    }
}
