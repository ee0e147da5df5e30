using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Scenes;

/// <summary>Computes the box of every block, on all cores.</summary>
internal static class BlockBounds
{
    private const int MinForParallel = 1024;

    public static void Fill(PrimitiveStore store)
    {
        var count = store.Blocks.Length;
        if (count < MinForParallel) FillRange(store, 0, count);
        else Parallel.ForEach(CoreRanges.Split(count), range => FillRange(store, range.From, range.To));
    }

    private static void FillRange(PrimitiveStore store, int from, int to)
    {
        for (var block = from; block < to; block++)
        {
            var box = Bounds2D.Empty;
            foreach (ref readonly var primitive in store.Block(block)) box = box.Union(store.BoundsOf(primitive));
            store.Blocks[block] = box;
        }
    }
}
