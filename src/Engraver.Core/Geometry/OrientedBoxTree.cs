namespace Engraver.Core.Geometry;

/// <summary>Oriented boxes in halves, quarters and so on, each half in its own oriented box. In dense diagonals and rings nearly every axis-parallel box
/// contains every point; only few oriented boxes do.</summary>
/// <remarks>Built in n log n steps. Counts the boxes that it examines, so not safe for use from several threads.</remarks>
public sealed class OrientedBoxTree
{
    /// <summary>Maximum number of items under a node that is not divided.</summary>
    internal const int LeafSize = 4;

    private readonly OrientedBox[] _items;
    private readonly int[] _order;
    private readonly List<OrientedBoxNode> _nodes;

    private OrientedBoxTree(OrientedBox[] items, int[] order, List<OrientedBoxNode> nodes) => (_items, _order, _nodes) = (items, order, nodes);

    /// <summary>Number of boxes examined since the tree was built, of nodes and of items.</summary>
    public long Steps { get; private set; }

    /// <summary>A tree over boxes; item numbers are indices into <paramref name="boxes"/>, which are taken over.</summary>
    public static OrientedBoxTree Build(OrientedBox[] boxes)
    {
        var (order, nodes) = OrientedBoxDivision.Divide(boxes);
        return new OrientedBoxTree(boxes, order, nodes);
    }

    /// <summary>The nearest item by <paramref name="measure"/>, ties to the lower number, or the first found that is near enough; -1 when none is nearer than
    /// or as near as <paramref name="within"/>.</summary>
    /// <param name="place">Point to measure from.</param>
    /// <param name="measure">Exact distance of an item, which is nowhere nearer than its box. Several items may be pieces of one object and measure the
    /// whole.</param>
    /// <param name="within">Largest distance of interest; positive infinity for any.</param>
    /// <param name="enough">The search ends at an item this near; 0 for the nearest of all, negative where ties matter.</param>
    /// <param name="distance">Distance of the result, or <paramref name="within"/> when there is none.</param>
    public int Nearest(Point2D place, BoxTree.Measure measure, double within, double enough, out double distance)
    {
        var best = new BoxTree.NearestItem(-1, within);
        if (_nodes.Count > 0) Descend(0, place, measure, enough, ref best);
        distance = best.Distance;
        return best.Item;
    }

    /// <summary>True when the box of an item comes within <paramref name="reach"/> of a line, an arc or a curve of one span, or nearly.</summary>
    /// <param name="counts">Selects the items that count; all when omitted.</param>
    public bool ComesNear(in Segment path, double reach, Predicate<int>? counts = null)
    {
        var box = OrientedBox.Around(path).Grown(reach);
        if (path.Kind == SegmentKind.Line || path.IsFreeCurve) return ComesNear(0, new Strip(box), counts);
        return ComesNear(0, new Ring(box, path.Arc.Centre, path.Arc.Radius - reach, path.Arc.Radius + reach), counts);
    }

    private void Descend(int index, Point2D place, BoxTree.Measure measure, double enough, ref BoxTree.NearestItem best)
    {
        var node = _nodes[index];
        if (node.IsLeaf)
        {
            Steps += node.Count;
            for (var slot = node.First; slot < node.First + node.Count && !IsEnough(best, enough); slot++)
            {
                var item = _order[slot];
                if (_items[item].DistanceTo(place) <= best.Distance) best.Offer(item, measure(item, place));
            }

            return;
        }

        Steps += 2;
        var (near, far) = (index + 1, node.Second);
        var (toNear, toFar) = (_nodes[near].Box.DistanceTo(place), _nodes[far].Box.DistanceTo(place));
        if (toFar < toNear) (near, far, toNear, toFar) = (far, near, toFar, toNear);
        if (toNear <= best.Distance) Descend(near, place, measure, enough, ref best);
        if (toFar <= best.Distance && !IsEnough(best, enough)) Descend(far, place, measure, enough, ref best);
    }

    private static bool IsEnough(in BoxTree.NearestItem best, double enough) => best.Item >= 0 && best.Distance <= enough;

    private bool ComesNear<TQuery>(int index, in TQuery query, Predicate<int>? counts)
        where TQuery : struct, IBoxQuery
    {
        if (_nodes.Count == 0) return false;
        Steps++;
        var node = _nodes[index];
        if (!query.Meets(node.Box)) return false;
        if (!node.IsLeaf) return ComesNear(index + 1, query, counts) || ComesNear(node.Second, query, counts);
        for (var slot = node.First; slot < node.First + node.Count; slot++)
        {
            Steps++;
            if (query.Meets(_items[_order[slot]]) && counts?.Invoke(_order[slot]) != false) return true;
        }

        return false;
    }

    private interface IBoxQuery
    {
        bool Meets(in OrientedBox box);
    }

    private readonly struct Strip(OrientedBox strip) : IBoxQuery
    {
        public bool Meets(in OrientedBox box) => strip.Overlaps(box);
    }

    /// <summary>Points within reach of an arc are in the arc's box and between two radii.</summary>
    private readonly struct Ring(OrientedBox around, Point2D centre, double least, double most) : IBoxQuery
    {
        public bool Meets(in OrientedBox box) => around.Overlaps(box) && box.DistanceTo(centre) <= most && box.FarthestFrom(centre) >= least;
    }
}

/// <summary>A node: a part of the items. The node of its first half, where it has one, follows directly.</summary>
/// <param name="Box">Box around all items under it.</param>
/// <param name="First">Index of its first item in the order.</param>
/// <param name="Count">Number of its items.</param>
/// <param name="Second">The node of its second half; 0 for a leaf.</param>
internal readonly record struct OrientedBoxNode(OrientedBox Box, int First, int Count, int Second)
{
    public bool IsLeaf => Second == 0;
}
