using Engraver.Core.Geometry;

namespace Engraver.Core.Posts;

/// <summary>Predicted machine position after each block of a text whose format rounds, and its distance from the path. Millimetres.</summary>
/// <param name="Start">Required machine position before the first block, drawing millimetres.</param>
/// <param name="Blocks">Blocks in order; at least one.</param>
/// <param name="MaxError">Largest distance of a cut from the path; 0 when nothing is cut.</param>
/// <param name="MaxClosure">Largest closure of a contour; null when no contour closes.</param>
public sealed record PostForecast(Point2D Start, IReadOnlyList<ForecastBlock> Blocks, double MaxError, double? MaxClosure);
