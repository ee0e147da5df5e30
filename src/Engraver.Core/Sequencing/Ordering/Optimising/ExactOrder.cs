using System.Numerics;

namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>The best order of few nodes with the best entries, by dynamic programming over the sets of nodes that were visited (Held and Karp).</summary>
internal sealed class ExactOrder<T>
    where T : struct, ITravelMeasure
{
    private const int MaxNodes = 12;
    private const long MaxLinks = 50_000_000;

    private readonly List<(int Node, int Entry, NodeEnds Ends)> _options = [];
    private readonly int _count;
    private readonly int[] _required;
    private readonly double[] _links;
    private readonly double[] _costs;
    private readonly int[] _from;
    private readonly NodeEnds _tool;
    private readonly T _measure;

    private ExactOrder(OrderProblem problem, T measure)
    {
        (_count, _measure, _tool) = (problem.Count - 1, measure, problem.EndsOf(0, 0));
        _required = new int[_count];
        foreach (var (before, after) in problem.Pairs) _required[after - 1] |= 1 << (before - 1);
        for (var node = 1; node <= _count; node++) AddOptions(problem, node);
        _links = new double[_options.Count * _options.Count];
        for (var link = 0; link < _links.Length; link++) _links[link] = Cost(_options[link / _options.Count].Ends, _options[link % _options.Count].Ends);
        (_costs, _from) = (new double[_options.Count << _count], new int[_options.Count << _count]);
        Array.Fill(_costs, double.PositiveInfinity);
    }

    /// <summary>The order as nodes with their entries, and its cost; null for too many nodes or entries.</summary>
    public static (IReadOnlyList<(int Node, int Entry)> Order, double Cost)? TryFind(OrderProblem problem, T measure)
    {
        var (count, places) = (problem.Count - 1, 0L);
        for (var node = 1; node <= count; node++) places += problem.PlacesOf(node).Length;
        return count is < 1 or > MaxNodes || (places * places) << Math.Max(0, count - 2) > MaxLinks ? null : new ExactOrder<T>(problem, measure).Find();
    }

    private void AddOptions(OrderProblem problem, int node)
    {
        var isDirected = problem.KindOf(node) == NodeKind.Directed;
        for (var entry = 0; entry < problem.PlacesOf(node).Length; entry++)
        {
            if (!isDirected || entry == problem.FirstEntryOf(node)) _options.Add((node - 1, entry, problem.EndsOf(node, entry)));
        }
    }

    private (IReadOnlyList<(int Node, int Entry)> Order, double Cost) Find()
    {
        for (var option = 0; option < _options.Count; option++)
        {
            if (_required[_options[option].Node] == 0) _costs[Index(1 << _options[option].Node, option)] = Cost(_tool, _options[option].Ends);
        }

        var all = (1 << _count) - 1;
        for (var visited = 1; visited < all; visited++) Extend(visited);
        var last = 0;
        for (var option = 1; option < _options.Count; option++)
        {
            if (Complete(all, option) < Complete(all, last)) last = option;
        }

        return (Path(all, last), Complete(all, last));
    }

    private double Complete(int all, int option) => _costs[Index(all, option)] + Cost(_options[option].Ends, _tool);

    private void Extend(int visited)
    {
        for (var from = 0; from < _options.Count; from++)
        {
            var cost = _costs[Index(visited, from)];
            if (double.IsPositiveInfinity(cost)) continue;
            for (var to = 0; to < _options.Count; to++)
            {
                var node = _options[to].Node;
                if ((visited >> node & 1) == 1 || (_required[node] & ~visited) != 0) continue;
                var next = Index(visited | (1 << node), to);
                var sum = cost + _links[(from * _options.Count) + to];
                if (sum < _costs[next]) (_costs[next], _from[next]) = (sum, from);
            }
        }
    }

    private (int Node, int Entry)[] Path(int visited, int option)
    {
        var order = new (int, int)[_count];
        for (var place = BitOperations.PopCount((uint)visited) - 1; place >= 0; place--)
        {
            var (node, entry, _) = _options[option];
            order[place] = (node + 1, entry);
            (visited, option) = (visited & ~(1 << node), _from[Index(visited, option)]);
        }

        return order;
    }

    private int Index(int visited, int option) => (visited * _options.Count) + option;

    private double Cost(in NodeEnds from, in NodeEnds to) => _measure.Of(to.InX - from.OutX, to.InY - from.OutY);
}
