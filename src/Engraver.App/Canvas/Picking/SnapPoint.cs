using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Picking;

/// <summary>A place that the cursor snaps to, and why (one kind).</summary>
/// <param name="Place">Drawing units.</param>
public readonly record struct SnapPoint(Point2D Place, SnapKinds Kind);
