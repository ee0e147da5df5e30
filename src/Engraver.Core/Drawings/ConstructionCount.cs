using Engraver.Core.Diagnostics;

namespace Engraver.Core.Drawings;

/// <summary>How often one type of construction other than text stands on one layer, blocks expanded. What is invisible itself or by its insert does not count.</summary>
/// <param name="Type">As DXF spells it (HATCH, DIMENSION, POINT).</param>
/// <param name="Layer">Index into <see cref="Drawing.Layers"/>: the layer that counts.</param>
/// <param name="First">Where the first one stands in the file, in a block: there.</param>
public readonly record struct ConstructionCount(string Type, int Layer, int Count, SourceRef First);
