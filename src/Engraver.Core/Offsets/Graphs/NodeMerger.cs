using System.Runtime.InteropServices;
using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets.Graphs;

/// <summary>Numbers points: points within a tolerance of each other get the same number.</summary>
internal sealed class NodeMerger
{
    /// <summary>Size of a grid cell in tolerances: large, so that few points are near the border of their cell and more than one cell is rarely
    /// searched.</summary>
    private const double CellTolerances = 1000.0;

    private readonly List<Point2D> _places;
    private readonly List<int> _leader;
    private readonly double _tolerance;
    private readonly double _cell;
    private readonly Dictionary<(long, long), List<int>> _cells = [];
    private readonly HashSet<int> _placed = [];

    public NodeMerger(IReadOnlyList<Point2D> places, IReadOnlyList<(int One, int Other)> same, double tolerance)
    {
        _places = [.. places];
        _leader = new List<int>(places.Count);
        for (var i = 0; i < places.Count; i++) _leader.Add(i);
        (_tolerance, _cell) = (tolerance, CellTolerances * tolerance);
        foreach (var (one, other) in same) Join(one, other);
    }

    public int Count => _places.Count;

    /// <summary>The number that represents a node and all nodes merged with it.</summary>
    public int Of(int node)
    {
        while (_leader[node] != node) node = _leader[node] = _leader[_leader[node]];
        return node;
    }

    public Point2D PlaceOf(int node) => _places[Of(node)];

    /// <summary>The node at a point, which is also the node of the piece ends at this point.</summary>
    /// <param name="place">Crossing point of two pieces.</param>
    /// <param name="first">Node of an end at this point, -1 for none.</param>
    /// <param name="second">Node of another end, -1 for none.</param>
    public int NodeAt(Point2D place, int first, int second)
    {
        if (first >= 0) Place(first);
        if (second >= 0) Place(second);
        if (first >= 0 && second >= 0) Join(first, second);
        if (first >= 0 || second >= 0) return Of(first >= 0 ? first : second);
        if (Find(place) is var near and >= 0) return Of(near);
        _places.Add(place);
        _leader.Add(_places.Count - 1);
        Place(_places.Count - 1);
        return Of(_places.Count - 1);
    }

    /// <summary>Enters an end node into the grid, where it can be merged with other nodes.</summary>
    private void Place(int node)
    {
        if (!_placed.Add(node)) return;
        if (Find(_places[node]) is var near and >= 0) Join(near, node);
        ref var list = ref CollectionsMarshal.GetValueRefOrAddDefault(_cells, CellOf(_places[node], 0.0, 0.0), out _);
        list ??= [];
        list.Add(node);
    }

    private void Join(int one, int other)
    {
        (one, other) = (Of(one), Of(other));
        if (one != other) _leader[Math.Max(one, other)] = Math.Min(one, other);
    }

    private int Find(Point2D place)
    {
        var own = CellOf(place, 0.0, 0.0);
        if (FindIn(own, place) is var near and >= 0) return near;
        for (var x = -1; x <= 1; x++)
        {
            for (var y = -1; y <= 1; y++)
            {
                var cell = CellOf(place, x * _tolerance, y * _tolerance);
                if (cell != own && FindIn(cell, place) is var found and >= 0) return found;
            }
        }

        return -1;
    }

    private int FindIn((long, long) cell, Point2D place)
    {
        if (!_cells.TryGetValue(cell, out var nodes)) return -1;
        foreach (var node in nodes)
        {
            if (_places[node].IsNear(place, _tolerance)) return node;
        }

        return -1;
    }

    private (long, long) CellOf(Point2D place, double x, double y) => ((long)Math.Floor((place.X + x) / _cell), (long)Math.Floor((place.Y + y) / _cell));
}
