using Engraver.Core.Geometry;

namespace Engraver.Core.Posts;

/// <summary>Predicted machine position after each block of a text whose format rounds, and its distance from the path. Millimetres.</summary>
/// <param name="Start">Required machine position before the first block, drawing millimetres.</param>
/// <param name="Blocks">Blocks in order; at least one.</param>
/// <param name="MaxError">Largest distance of a cut from the path; 0 when nothing is cut.</param>
/// <param name="MaxClosure">Largest closure of a contour; null when no contour closes.</param>
public sealed record PostForecast(Point2D Start, IReadOnlyList<ForecastBlock> Blocks, double MaxError, double? MaxClosure);

/// <summary>One block.</summary>
/// <param name="Part">The program that contains it, from 1.</param>
/// <param name="Number">Number in its program, from 1.</param>
/// <param name="End">Machine position after it, drawing millimetres.</param>
/// <param name="Error">Largest distance of its run from the path; null for positioning.</param>
/// <param name="Closure">Distance of the machine from an earlier point of the contour to which it returns; null elsewhere.</param>
public sealed record ForecastBlock(int Part, int Number, bool Cutting, Point2D End, double? Error, double? Closure);
