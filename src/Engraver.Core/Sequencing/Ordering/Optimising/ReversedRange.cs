namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>A range of a tour in reverse order, except that a node waits until all those that must come before it have been visited: a contour directly
/// follows the last one inside it. Every range can be reversed so.</summary>
internal sealed class ReversedRange(Tour tour, TourLimits limits)
{
    private readonly List<int> _nodes = [];

    /// <summary>For each node, the number of nodes of the range that must still come before it.</summary>
    private readonly int[] _missing = new int[tour.Count];
    private readonly bool[] _isWaiting = new bool[tour.Count];
    private readonly Stack<int> _ready = new();

    /// <summary>The nodes in the new order.</summary>
    public IReadOnlyList<int> Nodes => _nodes;

    /// <summary>Finds the order of a range of positions without the tool.</summary>
    public void Find(int first, int last)
    {
        _nodes.Clear();
        for (var position = first; position <= last; position++) _missing[tour.At(position)] = 0;
        for (var position = first; position <= last; position++)
        {
            foreach (var after in limits.Precedence.After(tour.At(position))) _missing[after]++;
        }

        for (var position = last; position >= first; position--)
        {
            var node = tour.At(position);
            if (_missing[node] > 0) _isWaiting[node] = true;
            else Visit(node);
        }

        for (var position = first; position <= last; position++) Forget(tour.At(position));
    }

    /// <summary>Where the tool enters and leaves a node of the range in the new order.</summary>
    public NodeEnds EndsOf(int node) => limits.IsDirected(node) ? tour.Ends[node] : tour.Ends[node].Turned;

    private void Visit(int node)
    {
        _ready.Push(node);
        while (_ready.TryPop(out var next))
        {
            _nodes.Add(next);
            foreach (var after in limits.Precedence.After(next))
            {
                if (--_missing[after] > 0 || !_isWaiting[after]) continue;
                _isWaiting[after] = false;
                _ready.Push(after);
            }
        }
    }

    /// <summary>Nodes behind the range were counted too.</summary>
    private void Forget(int node)
    {
        foreach (var after in limits.Precedence.After(node)) _missing[after] = 0;
    }
}
