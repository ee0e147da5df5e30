using Engraver.Core.Diagnostics;

namespace Engraver.Core.Drawings;

/// <summary>Number of entities of one type of construction other than text on one layer, blocks expanded. An entity that is invisible itself or through its
/// insert is not counted.</summary>
/// <param name="Type">The DXF name (HATCH, DIMENSION, POINT).</param>
/// <param name="Layer">Index into <see cref="Drawing.Layers"/>: the effective layer.</param>
/// <param name="First">Where the first one is in the file (in a block: the block's entity).</param>
public readonly record struct ConstructionCount(string Type, int Layer, int Count, SourceRef First);
