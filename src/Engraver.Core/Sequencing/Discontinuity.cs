using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>A contour end with no partner within the join tolerance.</summary>
/// <param name="Place">Where, millimetres.</param>
/// <param name="Row">The row that ends here.</param>
/// <param name="Gap">Distance to the nearest other open end (it may be the other end of the same contour); null when there is no other.</param>
/// <param name="NearestRow">The row of that other end; -1 without one.</param>
public readonly record struct Discontinuity(Point2D Place, int Row, double? Gap, int NearestRow);
