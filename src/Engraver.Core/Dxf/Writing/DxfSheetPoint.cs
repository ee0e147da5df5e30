using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf.Writing;

/// <summary>A point of a written drawing.</summary>
/// <param name="Layer">Name of one of the sheet's layers.</param>
/// <param name="Linetype">Name of its linetype; null for by layer.</param>
public readonly record struct DxfSheetPoint(PlacedPoint Point, string Layer, string? Linetype);
