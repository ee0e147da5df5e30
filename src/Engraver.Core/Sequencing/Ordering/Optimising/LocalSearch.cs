namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Improves a tour by the best change at each node until there is none: other entries, 2-opt, Or-opt, Or-3opt and moves of blocks.</summary>
/// <typeparam name="T">The cost of a move.</typeparam>
internal sealed class LocalSearch<T>
    where T : struct, ITravelMeasure
{
    /// <summary>Smaller gains are rounding.</summary>
    private const double MinGain = 1e-9;

    private readonly Tour _tour;
    private readonly TourLimits _limits;
    private readonly NodeQueue _queue;
    private readonly TravelCosts<T> _costs;
    private readonly ReversalMoves<T> _reversals;
    private readonly PartMoves<T> _parts;
    private readonly SwapMoves<T> _swaps;

    public LocalSearch(OrderProblem problem, Tour tour, TourLimits limits, Neighbors neighbors, T measure)
    {
        (_tour, _limits, _queue) = (tour, limits, new NodeQueue(problem.Count));
        _costs = new TravelCosts<T>(problem, tour, measure);
        _reversals = new ReversalMoves<T>(tour, limits, neighbors, _costs);
        _parts = new PartMoves<T>(tour, limits, neighbors, _costs);
        _swaps = new SwapMoves<T>(tour, limits, neighbors, _costs);
    }

    public TravelCosts<T> Costs => _costs;

    /// <summary>Requests an improvement at this node.</summary>
    public void Enqueue(int node) => _queue.Add(node);

    /// <summary>Requests an improvement at these nodes.</summary>
    public void Enqueue(int a, int b, int c, int d) => _queue.Add(a, b, c, d);

    /// <summary>Reverses a range of positions as far as the required order allows, and requests an improvement there.</summary>
    /// <returns>By how much the cost decreased.</returns>
    public double Reverse(int first, int last) => _reversals.ReverseOrdered(first, last, _queue);

    /// <summary>Improves until no requested node has a better change.</summary>
    /// <returns>By how much the cost decreased.</returns>
    public double Run(CancellationToken stop)
    {
        var gain = 0.0;
        while (_queue.TryTake(out var node))
        {
            if (stop.IsCancellationRequested)
            {
                _queue.Clear();
                break;
            }

            while (BestAt(node) is { Kind: not TourChangeKind.None } change)
            {
                gain += change.Gain;
                Apply(change);
            }
        }

        return gain;
    }

    private TourChange BestAt(int node)
    {
        var best = new TourChange(TourChangeKind.None, 0, 0, 0, 0, MinGain);
        if (node != 0) TryEntries(node, ref best);
        _reversals.Find(node, ref best);
        _parts.Find(node, ref best);
        _swaps.Find(node, ref best);
        return best;
    }

    private void TryEntries(int node, ref TourChange best)
    {
        var (previous, next) = (_tour.Previous(node), _tour.Next(node));
        var now = _costs.Link(previous, node) + _costs.Link(node, next);
        var (cost, entry) = _costs.BestBetween(node, previous, next);
        if (now - cost > best.Gain) best = new TourChange(TourChangeKind.Entry, node, 0, 0, entry, now - cost);
    }

    private void Apply(in TourChange change)
    {
        switch (change.Kind)
        {
            case TourChangeKind.Entry:
                _tour.SetEntry(change.A, change.D);
                EnqueueAround(change.A);
                return;
            case TourChangeKind.Reverse:
                _tour.Exchange(change.A, change.B, change.C, change.D);
                _queue.Add(change.A, change.B, change.C, change.D);
                return;
            case TourChangeKind.ReverseOrdered:
                _reversals.ReverseOrdered(change.A, change.B, _queue);
                return;
            case TourChangeKind.Swap:
                _queue.Add(change.A, _tour.Next(change.A), change.B, _tour.Next(change.B));
                _queue.Add(change.C, _tour.Next(change.C), change.C, change.C);
                _tour.Swap(change.A, change.B, change.C);
                return;
            default:
                Move(change);
                return;
        }
    }

    private void Move(in TourChange change)
    {
        var before = _tour.Next(change.C);
        _queue.Add(_tour.Previous(change.A), _tour.Next(change.B), change.C, before);
        _queue.Add(change.A, change.B, change.A, change.A);
        _tour.Move(change.A, change.B, change.C, change.Kind == TourChangeKind.MoveTurned);
        if (change.Kind == TourChangeKind.MoveOne) _tour.SetEntry(change.A, _costs.EntryFor(change.A, change.D, isTurned: _tour.Next(change.C) != change.A));
    }

    private void EnqueueAround(int node) => _queue.Add(_tour.Previous(node), node, _tour.Next(node), node);
}
