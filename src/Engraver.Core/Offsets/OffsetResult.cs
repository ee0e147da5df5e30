using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets;

/// <summary>The result of <see cref="ContourOffset"/>. For the material (in, out), outer loops run counter-clockwise and holes clockwise; left and right
/// offsets run in the drawn direction.</summary>
/// <param name="Loops">Empty when nothing remains.</param>
/// <param name="MaxDeviation">Largest difference between the requested distance and the measured distance of the result from the drawn contours, millimetres;
/// corners with a mitre or bevel are excluded.</param>
/// <param name="WithoutInside">Number of open contours that were left out because they have no inside.</param>
/// <param name="Unresolved">Points where the result could not be closed and was left out; none in any drawing tested so far.</param>
public sealed record OffsetResult(IReadOnlyList<OffsetLoop> Loops, double MaxDeviation, int WithoutInside, IReadOnlyList<Point2D> Unresolved);
