using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Picking;

/// <summary>A snap point and its (single) kind.</summary>
/// <param name="Place">Drawing units.</param>
public readonly record struct SnapPoint(Point2D Place, SnapKinds Kind);
