using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf;

/// <summary>A curve of a written drawing: a segment with its direction, its layer, and what our own program wants to find again.</summary>
/// <param name="Segment">Millimetres; written so that it reads back with this start, end and direction.</param>
/// <param name="Layer">Name of one of the sheet's layers.</param>
/// <param name="Role">First text of the extended data; null: none is written.</param>
/// <param name="Sequence">Place in the order of cutting, 1 is first; 0 for what is not cut.</param>
/// <param name="Stroke">The stroke it belongs to or leads to, 1 is first.</param>
public readonly record struct DxfSheetEntity(Segment Segment, string Layer, string? Role, int Sequence, int Stroke);
