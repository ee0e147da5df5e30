using Engraver.Core.Geometry;

namespace Engraver.Core.Pockets;

/// <summary>A region that is too narrow for the tool.</summary>
/// <param name="Place">The widest point of the region.</param>
/// <param name="Width">Diameter of the largest circle in it, mm.</param>
public sealed record NarrowRegion(Point2D Place, double Width);
