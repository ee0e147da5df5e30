using Engraver.Core.Geometry;

namespace Engraver.Core.Pockets;

/// <summary>A piece of the pocket that the round tool cannot reach: a corner, or a neck that is too narrow.</summary>
/// <param name="Place">The point of the piece on the wall that is farthest from the reached area.</param>
/// <param name="Depth">Distance of that point from the reached area, mm.</param>
/// <param name="Area">Area, mm2; null when its boundary could not be closed.</param>
public sealed record UnreachedPlace(Point2D Place, double Depth, double? Area);
