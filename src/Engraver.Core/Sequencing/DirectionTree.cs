using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>Segment ends sorted into small squares, and within each by the direction into their segments, under a tree of boxes with four children to a node.
/// Finds the near end that continues straightest.</summary>
internal sealed class DirectionTree
{
    private const int Fanout = 4;
    private const int NoItem = int.MaxValue;
    private const double SmallestSquare = 1e-9;
    private readonly int[] _ends;

    /// <summary>For each level, leaves first: box of the directions, box of the positions, lowest end that has not been removed.</summary>
    private readonly Node[][] _levels;

    private DirectionTree(int[] ends, Node[] leaves)
    {
        _ends = ends;
        var levels = new List<Node[]> { leaves };
        while (levels[^1].Length > 1) levels.Add([.. levels[^1].Chunk(Fanout).Select(children => children.Aggregate((a, b) => a.With(b)))]);
        _levels = [.. levels];
    }

    /// <summary>Number of nodes that were tested.</summary>
    public long Comparisons { get; private set; }

    /// <param name="ends">Numbers of ends.</param>
    /// <param name="places">Position of each end, by its number.</param>
    /// <param name="reach">Largest distance that queries use, mm: squares are about as large, so that ends beyond it are in other boxes than those
    /// within.</param>
    /// <param name="travelInto">Direction into its segment, length 1.</param>
    public static DirectionTree Build(int[] ends, Point2D[] places, double reach, Func<int, Vector2D> travelInto)
    {
        var square = Math.Max(reach / 2.0, SmallestSquare);
        var sorted = ends.Select(end => (End: end, Into: travelInto(end)))
            .OrderBy(item => Math.Floor(places[item.End].X / square)).ThenBy(item => Math.Floor(places[item.End].Y / square))
            .ThenBy(item => Math.Atan2(item.Into.Y, item.Into.X)).ThenBy(item => item.End).ToArray();
        return new DirectionTree([.. sorted.Select(item => item.End)], [.. sorted.Select(item => new Node(PointBox(Point2D.Origin + item.Into), PointBox(places[item.End]), item.End))]);
    }

    /// <summary>The largest cosine between the direction of travel and that of a near end that counts; <paramref name="best"/> when none is larger.</summary>
    public double Straightest(in Query query, double best)
    {
        if (_ends.Length > 0) Straightest(_levels.Length - 1, 0, query, ref best);
        return best;
    }

    /// <summary>The lowest near end that counts and continues with this cosine or a larger one; <paramref name="best"/> when none is lower.</summary>
    public int Lowest(in Query query, double leastCosine, int best)
    {
        if (_ends.Length > 0) Lowest(_levels.Length - 1, 0, query, leastCosine, ref best);
        return best;
    }

    private void Straightest(int level, int index, in Query query, ref double best)
    {
        Comparisons++;
        var node = _levels[level][index];
        if (node.Lowest == NoItem || node.LargestCosine(query.Travel) <= best || !node.Reaches(query)) return;
        if (level == 0)
        {
            if (Counts(index, query)) best = node.LargestCosine(query.Travel);
            return;
        }

        foreach (var child in Children(level, index, query, (child, travel) => -child.LargestCosine(travel))) Straightest(level - 1, child, query, ref best);
    }

    private void Lowest(int level, int index, in Query query, double leastCosine, ref int best)
    {
        Comparisons++;
        var node = _levels[level][index];
        if (node.Lowest >= best || node.LargestCosine(query.Travel) < leastCosine || !node.Reaches(query)) return;
        if (level == 0)
        {
            if (Counts(index, query)) best = node.Lowest;
            return;
        }

        foreach (var child in Children(level, index, query, (child, _) => child.Lowest)) Lowest(level - 1, child, query, leastCosine, ref best);
    }

    /// <summary>True when the leaf's end may be chosen. An end that can never be chosen again is removed from the tree.</summary>
    private bool Counts(int leaf, in Query query)
    {
        if (query.Counts(_ends[leaf])) return _levels[0][leaf].Reaches(query);
        if (query.IsGone(_ends[leaf])) Remove(leaf);
        return false;
    }

    private void Remove(int index)
    {
        _levels[0][index] = _levels[0][index] with { Lowest = NoItem };
        for (var level = 1; level < _levels.Length; level++)
        {
            index /= Fanout;
            var below = _levels[level - 1];
            var lowest = NoItem;
            for (var child = index * Fanout; child < Math.Min((index + 1) * Fanout, below.Length); child++) lowest = Math.Min(lowest, below[child].Lowest);
            _levels[level][index] = _levels[level][index] with { Lowest = lowest };
        }
    }

    private int[] Children(int level, int index, in Query query, Func<Node, Vector2D, double> key)
    {
        var below = _levels[level - 1];
        var travel = query.Travel;
        return [.. Enumerable.Range(index * Fanout, Math.Min(Fanout, below.Length - (index * Fanout))).OrderBy(child => key(below[child], travel))];
    }

    private static Bounds2D PointBox(Point2D place) => Bounds2D.FromCorners(place, place);

    /// <param name="Here">Present end of the contour.</param>
    /// <param name="Reach">Largest distance of an end from there, mm.</param>
    /// <param name="Travel">Direction of travel, length 1.</param>
    /// <param name="Counts">True for ends that may be chosen.</param>
    /// <param name="IsGone">True for ends that can never be chosen again.</param>
    internal readonly record struct Query(Point2D Here, double Reach, Vector2D Travel, Predicate<int> Counts, Predicate<int> IsGone);

    private readonly record struct Node(Bounds2D Directions, Bounds2D Places, int Lowest)
    {
        public Node With(Node other) => new(Directions.Union(other.Directions), Places.Union(other.Places), Math.Min(Lowest, other.Lowest));

        /// <summary>An upper bound of the cosine over the box; exact for a leaf. Rounding is monotonic and keeps the order.</summary>
        public double LargestCosine(Vector2D travel) =>
            (travel.X * (travel.X > 0.0 ? Directions.MaxX : Directions.MinX)) + (travel.Y * (travel.Y > 0.0 ? Directions.MaxY : Directions.MinY));

        /// <summary>False when every position is out of reach; for a leaf the same decision as <see cref="Point2D.IsNear"/>.</summary>
        public bool Reaches(in Query query)
        {
            var nearest = new Point2D(Math.Clamp(query.Here.X, Places.MinX, Places.MaxX), Math.Clamp(query.Here.Y, Places.MinY, Places.MaxY));
            return nearest.IsNear(query.Here, query.Reach);
        }
    }
}
