namespace Engraver.Core.Geometry;

/// <summary>Oriented boxes in halves, quarters and so on, each half in an oriented box of its own. Of crowded diagonals and rings nearly every axis-parallel box holds every place; of these few do.</summary>
/// <remarks>Built in n log n steps. Counts what it looks at, so not safe for use from several threads.</remarks>
public sealed class OrientedBoxTree
{
    /// <summary>Items under a node that is not divided.</summary>
    internal const int LeafSize = 4;

    private readonly OrientedBox[] _items;
    private readonly int[] _order;
    private readonly List<OrientedBoxNode> _nodes;
    private readonly Slant[] _slants;
    private readonly Slant[] _nodeSlants;

    private OrientedBoxTree(OrientedBox[] items, Slant[] slants, int[] order, List<OrientedBoxNode> nodes)
    {
        (_items, _slants, _order, _nodes, _nodeSlants) = (items, slants, order, nodes, new Slant[nodes.Count]);
        for (var index = nodes.Count - 1; index >= 0; index--) _nodeSlants[index] = SlantOf(index); // halves stand behind the whole
    }

    /// <summary>Boxes that were looked at since the tree was built, of nodes and of items.</summary>
    public long Steps { get; private set; }

    /// <summary>A tree over boxes; item numbers are indices into <paramref name="boxes"/>, which are taken over.</summary>
    public static OrientedBoxTree Build(OrientedBox[] boxes) => Build(boxes, [.. boxes.Select(_ => Slant.Unknown)]);

    /// <summary>As above, with what is known of the directions in each box.</summary>
    internal static OrientedBoxTree Build(OrientedBox[] boxes, Slant[] slants)
    {
        var (order, nodes) = OrientedBoxDivision.Divide(boxes);
        return new OrientedBoxTree(boxes, slants, order, nodes);
    }

    /// <summary>The nearest item by <paramref name="measure"/>, ties to the lower number; -1 when none is nearer than or as near as <paramref name="within"/>.</summary>
    /// <param name="place">Seen from here.</param>
    /// <param name="measure">Exact distance of an item, which is nowhere nearer than its box. Several items may be pieces of one thing and measure the whole.</param>
    /// <param name="within">Largest distance of interest; positive infinity for any.</param>
    /// <param name="distance">Distance of the answer, or <paramref name="within"/> when there is none.</param>
    public int Nearest(Point2D place, BoxTree.Measure measure, double within, out double distance)
    {
        var best = new BoxTree.Best(-1, within);
        if (_nodes.Count > 0) Descend(0, place, measure, ref best);
        distance = best.Distance;
        return best.Item;
    }

    /// <summary>Adds every item whose box comes within <paramref name="radius"/> of a place, in no particular order.</summary>
    public void Around(Point2D place, double radius, List<int> found) => Collect(0, new Disc(place, radius), found);

    /// <summary>Adds every item whose box comes within <paramref name="reach"/> of a line or an arc, and some that do not quite, in no particular order.</summary>
    public void Along(in Segment path, double reach, List<int> found)
    {
        var box = OrientedBox.Around(path).Grown(reach);
        if (path.Kind == SegmentKind.Line) Collect(0, new Strip(box), found);
        else Collect(0, new Ring(box, path.Arc.Centre, path.Arc.Radius - reach, path.Arc.Radius + reach), found);
    }

    /// <summary>As <see cref="Along"/> a line, without what it only crosses (<see cref="Slant.Crossed"/>).</summary>
    internal void AlongNotAcross(LineSegment line, double reach, List<int> found) => Collect(0, new Course(OrientedBox.Around(line.Start, line.End).Grown(reach)), found);

    private Slant SlantOf(int index)
    {
        var (node, slant) = (_nodes[index], Slant.None);
        if (!node.IsLeaf)
        {
            foreach (var half in (ReadOnlySpan<int>)[index + 1, node.Second]) slant = slant.With(_nodeSlants[half], node.Box.Along, _nodes[half].Box.Along);
            return slant;
        }

        for (var slot = node.First; slot < node.First + node.Count; slot++) slant = slant.With(_slants[_order[slot]], node.Box.Along, _items[_order[slot]].Along);
        return slant;
    }

    private void Descend(int index, Point2D place, BoxTree.Measure measure, ref BoxTree.Best best)
    {
        var node = _nodes[index];
        if (node.IsLeaf)
        {
            Steps += node.Count;
            for (var slot = node.First; slot < node.First + node.Count; slot++)
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
        if (toNear <= best.Distance) Descend(near, place, measure, ref best);
        if (toFar <= best.Distance) Descend(far, place, measure, ref best);
    }

    private void Collect<TQuery>(int index, in TQuery query, List<int> found)
        where TQuery : struct, IBoxQuery
    {
        if (_nodes.Count == 0) return;
        Steps++;
        var node = _nodes[index];
        if (!query.Meets(node.Box, _nodeSlants[index])) return;
        if (!node.IsLeaf)
        {
            Collect(index + 1, query, found);
            Collect(node.Second, query, found);
            return;
        }

        Steps += node.Count;
        for (var slot = node.First; slot < node.First + node.Count; slot++)
        {
            if (query.Meets(_items[_order[slot]], _slants[_order[slot]])) found.Add(_order[slot]);
        }
    }

    private interface IBoxQuery
    {
        bool Meets(in OrientedBox box, Slant slant);
    }

    private readonly struct Disc(Point2D place, double radius) : IBoxQuery
    {
        public bool Meets(in OrientedBox box, Slant slant) => box.DistanceTo(place) <= radius;
    }

    private readonly struct Strip(OrientedBox strip) : IBoxQuery
    {
        public bool Meets(in OrientedBox box, Slant slant) => strip.Overlaps(box);
    }

    private readonly struct Course(OrientedBox strip) : IBoxQuery
    {
        public bool Meets(in OrientedBox box, Slant slant) => !slant.IsCrossed(box.Along, strip.Along) && strip.Overlaps(box);
    }

    /// <summary>What is within reach of an arc lies in the arc's box, and between two radii.</summary>
    private readonly struct Ring(OrientedBox around, Point2D centre, double least, double most) : IBoxQuery
    {
        public bool Meets(in OrientedBox box, Slant slant) => around.Overlaps(box) && box.DistanceTo(centre) <= most && box.FarthestFrom(centre) >= least;
    }
}

/// <summary>A half of a half of the items. Its first half, where it has any, is the next node.</summary>
/// <param name="Box">Round all items under it.</param>
/// <param name="First">Where its items begin in the order.</param>
/// <param name="Count">How many they are.</param>
/// <param name="Second">The node of its second half; 0 for a leaf.</param>
internal readonly record struct OrientedBoxNode(OrientedBox Box, int First, int Count, int Second)
{
    public bool IsLeaf => Second == 0;
}

/// <summary>The directions of what is in a box, and which crossings of it matter.</summary>
/// <param name="Turn">Sine of the largest angle between the box and a direction of what is in it; 1 for any.</param>
/// <param name="Crossed">Sine of the angle from which on a line that crosses what is in the box need not be found; 1 when every line must be.</param>
internal readonly record struct Slant(double Turn, double Crossed)
{
    public static Slant Unknown => new(1.0, 1.0);

    public static Slant None => default;

    /// <summary>With what is in another box, of another direction.</summary>
    public Slant With(Slant other, Vector2D own, Vector2D others) => new(Math.Min(1.0, Math.Max(Turn, other.Turn + Math.Abs(own.Cross(others)))), Math.Max(Crossed, other.Crossed));

    /// <summary>True when a line crosses all that is in the box at more than that angle.</summary>
    public bool IsCrossed(Vector2D own, Vector2D line) =>
        Turn < 1.0 && (Math.Abs(own.Cross(line)) * Math.Sqrt(1.0 - (Turn * Turn))) - (Math.Abs(own.Dot(line)) * Turn) > Crossed;
}
