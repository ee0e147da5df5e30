using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>Two different points.</summary>
public readonly record struct PointPair(Point2D First, Point2D Second)
{
    /// <summary>From the first to the second.</summary>
    public Vector2D Span => Second - First;

    public Point2D Middle => First + (Span * 0.5);
}
