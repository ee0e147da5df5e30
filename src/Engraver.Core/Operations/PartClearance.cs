using Engraver.Core.Geometry;

namespace Engraver.Core.Operations;

/// <summary>Distances from the contours of the parts that are cut out.</summary>
/// <param name="contours">Segments as drawn, millimetres.</param>
internal sealed class PartClearance(Segment[] contours)
{
    private readonly BoxTree _boxes = BoxTree.Build([.. contours.Select(segment => segment.Bounds)]);

    /// <summary>Distance of a place from the nearest contour; infinite without one.</summary>
    public double At(Point2D place)
    {
        _boxes.Nearest(place, (item, from) => contours[item].DistanceTo(from), double.PositiveInfinity, out var distance);
        return distance;
    }
}
