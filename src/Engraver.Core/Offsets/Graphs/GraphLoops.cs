namespace Engraver.Core.Offsets.Graphs;

/// <summary>The edges of a graph that bound an area, and the loops that they form.</summary>
/// <remarks>Between two crossings a chain is either completely part of the boundary or not at all, so that one decision is made for a whole run. At every node
/// the numbers of arriving and leaving boundary edges must be equal: where they are not, a crossing at a very small angle was evaluated in two ways, and the
/// caller retries.</remarks>
internal sealed class GraphLoops
{
    private readonly PieceGraph _graph;
    private readonly bool[] _kept;
    private readonly int[] _arriving;
    private readonly int[] _leaving;
    private readonly int[] _onlyNext;

    private GraphLoops(PieceGraph graph)
    {
        _graph = graph;
        _kept = new bool[graph.Edges.Count];
        (_arriving, _leaving, _onlyNext) = (new int[graph.NodeCount], new int[graph.NodeCount], new int[graph.NodeCount]);
    }

    /// <summary>Nodes at which edges were left over.</summary>
    public List<int> Unbalanced { get; } = [];

    /// <param name="graph">The graph; edges that are used backwards are reversed in it.</param>
    /// <param name="counts">False for an edge that is not counted.</param>
    /// <param name="judge">Decides about edges that follow each other.</param>
    public static GraphLoops From(PieceGraph graph, Func<int, bool> counts, Func<IReadOnlyList<int>, RunUse> judge)
    {
        var loops = new GraphLoops(graph);
        loops.Judge(counts, judge);
        loops.RemoveUnbalanced();
        return loops;
    }

    /// <summary>Loops of edges, each with the area on its left.</summary>
    public List<List<int>> Loops()
    {
        var next = Next();
        var loops = new List<List<int>>();
        for (var edge = 0; edge < _kept.Length; edge++)
        {
            if (!_kept[edge]) continue;
            var loop = new List<int>();
            for (var at = edge; _kept[at]; at = next[at])
            {
                _kept[at] = false;
                loop.Add(at);
            }

            loops.Add(loop);
        }

        return loops;
    }

    private void Judge(Func<int, bool> counts, Func<IReadOnlyList<int>, RunUse> judge)
    {
        Count(counts);
        var (seen, backwards, run) = (new bool[_kept.Length], new List<int>(), new List<int>());
        for (var pass = 0; pass < 2; pass++)
        {
            for (var edge = 0; edge < seen.Length; edge++)
            {
                if (seen[edge] || !counts(edge) || (pass == 0 && IsPlain(_graph.Edges[edge].Start))) continue;
                FindRun(edge, seen, run);
                var breaksOff = _arriving[_graph.Edges[edge].Start] == 0 || _leaving[_graph.Edges[run[^1]].End] == 0;
                var use = breaksOff ? RunUse.None : judge(run);
                if (use == RunUse.None) continue;
                foreach (var kept in run) _kept[kept] = true;
                if (use == RunUse.Backwards) backwards.AddRange(run);
            }
        }

        foreach (var edge in backwards) _graph.Reverse(edge);
    }

    /// <summary>A run continues through every node at which no other edge meets; the edges that remain after the runs between branching nodes are whole
    /// loops.</summary>
    private void FindRun(int first, bool[] seen, List<int> run)
    {
        run.Clear();
        for (var edge = first; !seen[edge]; edge = _onlyNext[_graph.Edges[edge].End])
        {
            seen[edge] = true;
            run.Add(edge);
            if (!IsPlain(_graph.Edges[edge].End)) break;
        }
    }

    private bool IsPlain(int node) => _arriving[node] == 1 && _leaving[node] == 1;

    private void Count(Func<int, bool> counts)
    {
        Array.Clear(_arriving);
        Array.Clear(_leaving);
        for (var edge = 0; edge < _kept.Length; edge++)
        {
            if (!counts(edge)) continue;
            var (start, end) = (_graph.Edges[edge].Start, _graph.Edges[edge].End);
            _leaving[start]++;
            _arriving[end]++;
            _onlyNext[start] = edge;
        }
    }

    /// <summary>Removes dead ends, so that the remaining edges close in every case.</summary>
    private void RemoveUnbalanced()
    {
        Count(edge => _kept[edge]);
        for (var node = 0; node < _arriving.Length; node++)
        {
            if (_arriving[node] != _leaving[node]) Unbalanced.Add(node);
        }

        for (var changed = Unbalanced.Count > 0; changed;)
        {
            changed = false;
            for (var edge = 0; edge < _kept.Length; edge++)
            {
                if (!_kept[edge] || (_leaving[_graph.Edges[edge].End] > 0 && _arriving[_graph.Edges[edge].Start] > 0)) continue;
                _kept[edge] = false;
                changed = true;
            }

            Count(edge => _kept[edge]);
        }
    }

    private int[] Next()
    {
        Count(edge => _kept[edge]);
        var next = new int[_kept.Length];
        var crowded = new Dictionary<int, (List<int> Arriving, List<int> Leaving)>();
        for (var edge = 0; edge < _kept.Length; edge++)
        {
            if (!_kept[edge]) continue;
            var (start, end) = (_graph.Edges[edge].Start, _graph.Edges[edge].End);
            if (IsPlain(end)) next[edge] = _onlyNext[end];
            else At(crowded, end).Arriving.Add(edge);
            if (!IsPlain(start)) At(crowded, start).Leaving.Add(edge);
        }

        foreach (var (node, edges) in crowded) Pair(node, edges.Arriving, edges.Leaving, next);
        return next;
    }

    private static (List<int> Arriving, List<int> Leaving) At(Dictionary<int, (List<int>, List<int>)> crowded, int node)
    {
        if (crowded.TryGetValue(node, out var edges)) return edges;
        return crowded[node] = ([], []);
    }

    /// <summary>Where several loops touch in a node, each continues along the boundary of the sector at which it arrived: the first edge clockwise. Loops
    /// touch there and do not cross.</summary>
    private void Pair(int node, List<int> arriving, List<int> leaving, int[] next)
    {
        var shortest = double.PositiveInfinity;
        foreach (var edge in arriving.Concat(leaving)) shortest = Math.Min(shortest, _graph.LengthOf(edge));
        foreach (var edge in arriving)
        {
            var from = Ray(node, edge, 1.0 - Share(edge, shortest));
            var best = leaving.MinBy(other => Clockwise(from, Ray(node, other, Share(other, shortest))));
            next[edge] = best;
            if (leaving.Count > 1) leaving.Remove(best);
        }
    }

    private double Share(int edge, double shortest) => 0.25 * shortest / _graph.LengthOf(edge);

    private double Ray(int node, int edge, double fraction)
    {
        var way = _graph.PointOn(edge, fraction) - _graph.PlaceOf(node);
        return Math.Atan2(way.Y, way.X);
    }

    private static double Clockwise(double from, double to)
    {
        var turn = from - to;
        return turn <= 0.0 ? turn + (2.0 * Math.PI) : turn;
    }
}
