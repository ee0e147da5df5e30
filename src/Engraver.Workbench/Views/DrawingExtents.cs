using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Views;

/// <summary>Extents of a drawing in plan, drawing units.</summary>
public static class DrawingExtents
{
    /// <summary>Bounding box of all visible curves and points, without hidden ones and those on frozen or switched-off layers. Empty if nothing is
    /// visible.</summary>
    public static Bounds2D Measure(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return drawing.Points.Where(point => point.IsVisibleIn(drawing)).Aggregate(Measure(drawing, DrawingPick.Visible(drawing)), (box, point) => box.Including(point.Plan));
    }

    /// <summary>Bounding box of some curves; empty for none.</summary>
    public static Bounds2D Measure(Drawing drawing, IEnumerable<int> entities)
    {
        var box = Bounds2D.Empty;
        foreach (var index in entities)
        {
            var entity = drawing.Entities[index];
            for (var part = entity.FirstPart; part < entity.FirstPart + entity.PartCount; part++) box = box.Union(drawing.SegmentOf(drawing.Parts[part]).Bounds);
        }

        return box;
    }
}
