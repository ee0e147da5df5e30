using Engraver.App.Canvas.Scenes;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Picking;

/// <summary>Finds what is under the pickbox. Drawing units.</summary>
public static class ScenePick
{
    /// <summary>The entity nearest to a point within <paramref name="within"/>; of equal distances the one drawn last; null if there is none.</summary>
    public static int? Nearest(CanvasScene scene, Point2D place, double within)
    {
        ArgumentNullException.ThrowIfNull(scene);
        var search = new EntitySearch(place, within);
        var store = scene.Store;
        for (var block = 0; block < store.Blocks.Length; block++)
        {
            if (Distance(store.Blocks[block], place) <= search.Within) search.Visit(store, block);
        }

        return search.Entity < 0 ? null : search.Entity;
    }

    /// <summary>Every entity within the distance, in drawing order, for selection cycling.</summary>
    public static IReadOnlyList<int> All(CanvasScene scene, Point2D place, double within)
    {
        ArgumentNullException.ThrowIfNull(scene);
        var found = new SortedSet<int>();
        var store = scene.Store;
        foreach (var block in store.BlocksTouching(Bounds2D.FromCorners(place, place).Grown(within)))
        {
            foreach (ref readonly var primitive in store.Block(block))
            {
                if (PrimitiveDistance.Measure(store, primitive, place, within) <= within) found.Add(primitive.Entity);
            }
        }

        return [.. found];
    }

    private static double Distance(in Bounds2D box, Point2D place)
    {
        var x = Math.Max(0.0, Math.Max(box.MinX - place.X, place.X - box.MaxX));
        var y = Math.Max(0.0, Math.Max(box.MinY - place.Y, place.Y - box.MaxY));
        return Math.Sqrt((x * x) + (y * y));
    }

    private struct EntitySearch(Point2D place, double within)
    {
        public int Entity { get; private set; } = -1;

        public double Within { get; private set; } = within;

        public void Visit(PrimitiveStore store, int block)
        {
            foreach (ref readonly var primitive in store.Block(block))
            {
                var distance = PrimitiveDistance.Measure(store, primitive, place, Within);
                if (!(distance < Within) && !(distance == Within && primitive.Entity > Entity)) continue;
                (Entity, Within) = (primitive.Entity, distance);
            }
        }
    }
}

/// <summary>Distance from a point to a primitive, drawing units.</summary>
internal static class PrimitiveDistance
{
    /// <summary>Exact up to <paramref name="within"/>; beyond it the result may be any larger number.</summary>
    public static double Measure(PrimitiveStore store, in ScenePrimitive primitive, Point2D place, double within)
    {
        if (primitive.Kind == SegmentKind.Line) return new LineSegment(new Point2D(primitive.A, primitive.B), new Point2D(primitive.C, primitive.D)).DistanceTo(place);
        if (!store.BoundsOf(primitive).Grown(within).Contains(place)) return double.PositiveInfinity;
        return store.SegmentOf(primitive).DistanceTo(place);
    }
}
