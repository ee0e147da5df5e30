using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf;

/// <summary>A text of a written drawing.</summary>
/// <param name="Text">As it was read; an MTEXT is written as one, every other as TEXT.</param>
/// <param name="Layer">Name of one of the sheet's layers.</param>
public readonly record struct DxfSheetText(PlacedText Text, string Layer);
