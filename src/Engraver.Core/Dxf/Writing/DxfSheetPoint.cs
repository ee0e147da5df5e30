using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf.Writing;

/// <summary>A point of a written drawing.</summary>
/// <param name="Layer">Name of one of the sheet's layers.</param>
public readonly record struct DxfSheetPoint(PlacedPoint Point, string Layer);
