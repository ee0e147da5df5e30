using Engraver.App.Canvas.Scenes;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Picking;

/// <summary>Distance from a place to a primitive, drawing units.</summary>
internal static class PrimitiveDistance
{
    /// <summary>Exact up to <paramref name="within"/>; beyond it any larger number may be answered.</summary>
    public static double Of(PrimitiveStore store, in ScenePrimitive primitive, Point2D place, double within)
    {
        if (primitive.Kind == SegmentKind.Line) return new LineSegment(new Point2D(primitive.A, primitive.B), new Point2D(primitive.C, primitive.D)).DistanceTo(place);
        if (!store.BoundsOf(primitive).Grown(within).Contains(place)) return double.PositiveInfinity;
        return store.SegmentOf(primitive).DistanceTo(place);
    }
}
