using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Writing;

/// <summary>An insert whose curves are written one by one.</summary>
/// <param name="Block">Name of its block.</param>
/// <param name="Number">The same for every curve of the insert.</param>
/// <param name="Position">Its insertion point, in the unit of the sheet.</param>
public readonly record struct DxfSheetInsert(string Block, int Number, Vector3D Position);
