namespace Engraver.Shaping;

/// <summary>A part of a text whose characters have one direction.</summary>
/// <param name="Start">Index of its first UTF-16 unit.</param>
internal readonly record struct DirectedPart(int Start, int Length, bool IsRightToLeft);
