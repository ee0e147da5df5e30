using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>For each node its nearest nodes, nearest first, with the least cost of a move between them.</summary>
internal sealed class Neighbors
{
    private const int UsualCapacity = 10;

    /// <summary>Few nodes have longer lists.</summary>
    private const int FewNodes = 64;
    private const int LargestCapacity = 24;

    /// <summary>Number of places of a node whose neighbours are searched; those of larger nodes are a sample.</summary>
    private const int MaxPlaces = 16;

    private readonly int[] _counts;
    private readonly (int Node, double Cost)[] _items;

    private Neighbors(int count)
    {
        Capacity = count > FewNodes ? UsualCapacity : LargestCapacity;
        (_counts, _items) = (new int[count], new (int, double)[count * Capacity]);
    }

    /// <summary>Largest number of nodes in the list of a node.</summary>
    public int Capacity { get; }

    public ReadOnlySpan<(int Node, double Cost)> Of(int node) => _items.AsSpan(node * Capacity, _counts[node]);

    public static Neighbors Find<T>(OrderProblem problem, T measure)
        where T : struct, ITravelMeasure
    {
        var found = new Neighbors(problem.Count);
        var (tree, near) = (new PlaceTree(problem), new NearList(found.Capacity));
        for (var node = 0; node < problem.Count; node++)
        {
            near.Clear(node);
            var places = problem.PlacesOf(node);
            var step = Math.Max(1, places.Length / MaxPlaces);
            for (var place = 0; place < places.Length; place += step) Search(tree, places[place], near);
            found.Enter(node, near, measure);
        }

        return found;
    }

    private static void Search(PlaceTree tree, Point2D place, NearList near)
    {
        if (!double.IsNaN(place.X)) tree.Nearest(place, near);
    }

    private void Enter<T>(int node, NearList near, T measure)
        where T : struct, ITravelMeasure
    {
        var items = _items.AsSpan(node * Capacity, near.Count);
        for (var i = 0; i < items.Length; i++) items[i] = (near[i].Node, measure.Of(near[i].Dx, near[i].Dy));
        items.Sort((a, b) => a.Cost != b.Cost ? a.Cost.CompareTo(b.Cost) : a.Node.CompareTo(b.Node));
        _counts[node] = items.Length;
    }
}
