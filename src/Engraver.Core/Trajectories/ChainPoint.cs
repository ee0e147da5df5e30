using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>A place of a chain.</summary>
/// <param name="Tangent">Direction of travel, length 1.</param>
/// <param name="Curvature">1/mm, left turn positive.</param>
internal readonly record struct ChainPoint(Point2D Point, Vector2D Tangent, double Curvature)
{
    /// <summary>Normal to the left of the direction of travel, length 1.</summary>
    public Vector2D Normal => new(-Tangent.Y, Tangent.X);
}
