using Engraver.Core.Geometry;

namespace Engraver.Core.Posts;

/// <summary>One block.</summary>
/// <param name="Part">The program that contains it, from 1.</param>
/// <param name="Number">Number in its program, from 1.</param>
/// <param name="End">Machine position after it, drawing millimetres.</param>
/// <param name="Error">Largest distance of its run from the path; null for positioning.</param>
/// <param name="Closure">Distance of the machine from an earlier point of the contour to which it returns; null elsewhere.</param>
public sealed record ForecastBlock(int Part, int Number, bool Cutting, Point2D End, double? Error, double? Closure);
