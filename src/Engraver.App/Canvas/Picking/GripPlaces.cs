using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Picking;

/// <summary>Where a selected entity shows its grips: ends, middle, centre and quadrants; of an entity of several parts the ends of the parts only.</summary>
internal static class GripPlaces
{
    public static IEnumerable<Point2D> Find(Drawing drawing, int entity)
    {
        var whole = drawing.Entities[entity].PartCount == 1;
        return DrawingPick.Segments(drawing, entity).SelectMany(SnapPlaces.Find).Where(point => whole || point.Kind == SnapKinds.End).Select(point => point.Place).Distinct();
    }
}
