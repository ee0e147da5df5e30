namespace Engraver.Shaping;

/// <summary>A feature of a font, switched on or off for a part of the text (OpenType specification, "Feature tags").</summary>
/// <param name="Tag">Four letters.</param>
/// <param name="Value">0 is off, 1 is on; a number selects one of several forms.</param>
public readonly record struct ShapingFeature(string Tag, uint Value, uint Start, uint End);
