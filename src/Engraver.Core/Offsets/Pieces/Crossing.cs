using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets.Pieces;

/// <summary>A common point of two pieces.</summary>
/// <param name="OnFirst">Fraction of the first piece's length, 0 to 1; exactly 0 or 1 at an end.</param>
/// <param name="OnSecond">The same for the second piece.</param>
internal readonly record struct Crossing(Point2D Place, double OnFirst, double OnSecond);
