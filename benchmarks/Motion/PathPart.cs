namespace Engraver.Benchmarks.Motion;

/// <summary>A part of a path as far as it bounds the speed. Millimetres and seconds.</summary>
/// <param name="Length">Above 0.</param>
/// <param name="Radius">Infinite on a straight.</param>
/// <param name="Through">Largest speed at its start.</param>
internal readonly record struct PathPart(double Length, double Radius, double Through);
