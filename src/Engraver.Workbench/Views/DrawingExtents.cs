using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Views;

/// <summary>Extents of a drawing in plan, drawing units.</summary>
public static class DrawingExtents
{
    /// <summary>Tight box of every visible curve and point: hidden ones and those on a frozen or switched-off layer do not count. Empty when nothing is
    /// visible.</summary>
    public static Bounds2D Measure(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return drawing.Points.Where(point => point.IsVisibleIn(drawing)).Aggregate(Measure(drawing, DrawingPick.Visible(drawing)), (box, point) => box.Including(point.Plan));
    }

    /// <summary>Tight box of some curves; empty for none.</summary>
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
