using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf;

/// <summary>What <see cref="DxfWriter"/> writes: layers, and curves in order, in millimetres.</summary>
/// <param name="Layers">Besides layer 0, which every drawing has.</param>
/// <param name="Entities">In the order in which they are to stand in the file.</param>
public sealed record DxfSheet(IReadOnlyList<DxfSheetLayer> Layers, IReadOnlyList<DxfSheetEntity> Entities)
{
    /// <summary>Tight box of the curves; empty when there is none.</summary>
    public Bounds2D Bounds => Entities.Aggregate(Bounds2D.Empty, (box, entity) => box.Union(entity.Segment.Bounds));
}
