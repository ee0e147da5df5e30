using Engraver.Core.Geometry;

namespace Engraver.Core.Posts;

/// <summary>Where the machine will be after each block of a text whose form rounds, and how far from the path. Millimetres.</summary>
/// <param name="Start">Where the machine must stand before the first block, drawing millimetres.</param>
/// <param name="Blocks">In order; at least one.</param>
/// <param name="MaxError">Largest distance of a cut from the path; 0 when nothing is cut.</param>
/// <param name="MaxClosure">Largest closure of a contour; null when none closes.</param>
public sealed record PostForecast(Point2D Start, IReadOnlyList<ForecastBlock> Blocks, double MaxError, double? MaxClosure);

/// <summary>One block.</summary>
/// <param name="Part">The program that it stands in, from 1.</param>
/// <param name="Number">In its program, from 1.</param>
/// <param name="End">Where the machine stands after it, drawing millimetres.</param>
/// <param name="Error">Largest distance of its run from the path; null for positioning.</param>
/// <param name="Closure">Where a contour comes back to where it was: how far the machine is from there; null elsewhere.</param>
public sealed record ForecastBlock(int Part, int Number, bool Cutting, Point2D End, double? Error, double? Closure);
