namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Iterated local search: changes a part of the tour at random, improves it there, and keeps the result unless it is worse. While the search is warm,
/// it also keeps somewhat worse results, to leave an order that no small change improves.</summary>
internal sealed class IteratedSearch<T>
    where T : struct, ITravelMeasure
{
    /// <summary>Largest number of nodes that a change rearranges in a large tour, so that a step takes the same time in every tour.</summary>
    private const int MaxLength = 1000;

    /// <summary>The same for the first improvement, which makes few changes.</summary>
    private const int MaxFirstLength = 25_000;

    /// <summary>A tour of fewer nodes has no parts to exchange.</summary>
    private const int MinVaried = 6;

    /// <summary>Number of steps between two checks and reports.</summary>
    private const int CheckSteps = 128;

    /// <summary>Rounding of the cost.</summary>
    private const double Rounding = 1e-9;

    private readonly Tour _tour;
    private readonly TourLimits _limits;
    private readonly LocalSearch<T> _local;
    private readonly EntryPass<T> _entries;
    private readonly TourKicks<T> _kicks;
    private readonly SearchRandom _random;

    public IteratedSearch(OrderProblem problem, Neighbors neighbors, T measure, ulong seed)
    {
        _tour = new Tour(problem);
        _limits = new TourLimits(problem, _tour);
        _local = new LocalSearch<T>(problem, _tour, _limits, neighbors, measure);
        _entries = new EntryPass<T>(problem, _tour, measure);
        _random = new SearchRandom(seed);
        _kicks = new TourKicks<T>(_tour, _limits, _local, _random);
    }

    public Tour Tour => _tour;

    /// <summary>Improves the order.</summary>
    /// <returns>The cost.</returns>
    public double Run(OrderSearch search)
    {
        _limits.MaxLength = MaxFirstLength;
        Improve(search.Stop);
        _limits.MaxLength = Math.Max(MaxLength, _tour.Count / 10);
        var (best, cost) = (_tour.Copy(), _local.Costs.Total());
        if (_tour.Count <= MinVaried) return cost;
        foreach (var round in OrderSteps.Rounds(search, _tour.Count - 1, _limits.IsConstrained))
        {
            if (search.Stop.IsCancellationRequested) break;
            if (round.IsReversed) Reverse(search.Stop);
            Vary(round, cost / _tour.Count, search);
            Improve(search.Stop);
            var now = _local.Costs.Total();
            if (now < cost) (best, cost) = (_tour.Copy(), now);
            else _tour.Restore(best);
        }

        return cost;
    }

    private void Reverse(CancellationToken stop)
    {
        _local.Reverse(1, _tour.Count - 1);
        Improve(stop);
    }

    private void Improve(CancellationToken stop)
    {
        _entries.Run();
        for (var position = 0; position < _tour.Count; position++) _local.Enqueue(_tour.At(position));
        _local.Run(stop);
        _entries.Run();
        _tour.Keep();
    }

    /// <param name="scale">Mean cost of a link.</param>
    private void Vary(in OrderRound round, double scale, OrderSearch search)
    {
        var heat = 0.0;
        for (var step = 0L; step < round.Steps; step++)
        {
            if (step % CheckSteps == 0)
            {
                if (search.Stop.IsCancellationRequested) return;
                heat = round.Heat * scale * (1.0 - ((double)step / round.Steps));
                search.Progress?.Report((double)step / round.Steps);
            }

            if (_kicks.Kick() is not { } cost) continue;
            if (cost - _local.Run(search.Stop) > Rounding + Tolerated(heat)) _tour.Undo();
            else _tour.Keep();
        }
    }

    /// <summary>By how much the next result may be worse: exponentially distributed.</summary>
    private double Tolerated(double heat) => heat > 0.0 ? -heat * Math.Log((1.0 + _random.Below(1 << 30)) / (1 << 30)) : 0.0;
}
