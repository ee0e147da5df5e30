using Engraver.App.Canvas.Scenes;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Picking;

/// <summary>What a box selects as a window or a crossing. Drawing units; entities in drawing order.</summary>
public static class SceneSelection
{
    /// <summary>Entities completely in the box, its border included (a window).</summary>
    public static IReadOnlyList<int> Inside(CanvasScene scene, Bounds2D box)
    {
        ArgumentNullException.ThrowIfNull(scene);
        var (store, drawing) = (scene.Store, scene.Shown);
        var inside = new int[drawing.Entities.Count];
        foreach (var block in store.BlocksTouching(box))
        {
            var whole = box.Contains(store.Blocks[block]);
            foreach (ref readonly var primitive in store.Block(block))
            {
                if (whole || box.Contains(store.BoundsOf(primitive))) inside[primitive.Entity]++;
            }
        }

        var found = new List<int>();
        for (var entity = 0; entity < inside.Length; entity++)
        {
            if (inside[entity] > 0 && inside[entity] == drawing.Entities[entity].PartCount) found.Add(entity);
        }

        return found;
    }

    /// <summary>Entities with any point in the box, its border included (a crossing).</summary>
    public static IReadOnlyList<int> Touching(CanvasScene scene, Bounds2D box)
    {
        ArgumentNullException.ThrowIfNull(scene);
        var store = scene.Store;
        var touched = new bool[scene.Shown.Entities.Count];
        foreach (var block in store.BlocksTouching(box))
        {
            var whole = box.Contains(store.Blocks[block]);
            foreach (ref readonly var primitive in store.Block(block))
            {
                if (!touched[primitive.Entity]) touched[primitive.Entity] = whole || Touches(store, primitive, box);
            }
        }

        var found = new List<int>();
        for (var entity = 0; entity < touched.Length; entity++)
        {
            if (touched[entity]) found.Add(entity);
        }

        return found;
    }

    private static bool Touches(PrimitiveStore store, in ScenePrimitive primitive, Bounds2D box)
    {
        var bounds = store.BoundsOf(primitive);
        if (!PrimitiveStore.Overlap(bounds, box)) return false;
        return box.Contains(bounds) || box.Touches(store.SegmentOf(primitive));
    }
}
