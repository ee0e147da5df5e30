using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Interaction;

/// <summary>A box drawn with the mouse, pixels. From left to right it is a window (completely inside), from right to left a crossing (touching).</summary>
internal readonly record struct SelectionBox(Point2D From, Point2D To)
{
    public bool IsCrossing => To.X < From.X;

    public Bounds2D Bounds => Bounds2D.FromCorners(From, To);
}
