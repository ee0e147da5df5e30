using Engraver.Core.Geometry;

namespace Engraver.Workbench.Lettering;

/// <summary>A straight line that belongs to the letters: underline, overline, strike-through, the bar of a fraction. In the plane of the layout.</summary>
public readonly record struct LayoutRule(Point2D From, Point2D To);
