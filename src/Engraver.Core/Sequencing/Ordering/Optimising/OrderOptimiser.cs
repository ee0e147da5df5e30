namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Finds an order of little travel: the best one of few nodes, otherwise the best that the steps of the search reach.</summary>
internal static class OrderOptimiser
{
    /// <summary>The nodes in order with their entries.</summary>
    /// <param name="problem">At least one node besides the tool, in an order that complies with the constraints.</param>
    public static IReadOnlyList<(int Node, int Entry)> Find(OrderProblem problem, OrderSearch search) => search.Cost is { X: { } x, Y: { } y }
        ? FindWithEnd(problem, search, new RapidMeasure(x, y))
        : FindWithEnd(problem, search, default(DistanceMeasure));

    private static IReadOnlyList<(int Node, int Entry)> FindWithEnd<T>(OrderProblem problem, OrderSearch search, T measure)
        where T : struct, ITravelMeasure => problem.EndIsFree ? Find(problem, search, new OpenEndMeasure<T>(measure)) : Find(problem, search, measure);

    private static IReadOnlyList<(int Node, int Entry)> Find<T>(OrderProblem problem, OrderSearch search, T measure)
        where T : struct, ITravelMeasure => ExactOrder<T>.TryFind(problem, measure) is { } exact ? exact.Order : Search(problem, search, measure);

    private static IReadOnlyList<(int Node, int Entry)> Search<T>(OrderProblem problem, OrderSearch search, T measure)
        where T : struct, ITravelMeasure
    {
        var neighbors = Neighbors.Find(problem, measure);
        var (tours, costs) = (new Tour[search.Searches], new double[search.Searches]);

        // On threads of their own: a search takes its core for seconds, and a job that runs meanwhile needs those of the pool.
        Task[] others = [.. Enumerable.Range(1, search.Searches - 1).Select(seed => Task.Factory.StartNew(() => Run(seed), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default))];
        Run(0);
        Task.WaitAll(others);
        return OrderOf(tours[Array.IndexOf(costs, costs.Min())]);

        void Run(int seed)
        {
            var one = new IteratedSearch<T>(problem, neighbors, measure, (ulong)seed);
            (costs[seed], tours[seed]) = (one.Run(seed == 0 ? search : search with { Progress = null }), one.Tour);
        }
    }

    /// <summary>The nodes from the start of the tool to its end.</summary>
    private static (int Node, int Entry)[] OrderOf(Tour tour)
    {
        var isTurned = tour.EntryOf(0) != 0;
        var order = new (int, int)[tour.Count - 1];
        var node = 0;
        for (var i = 0; i < order.Length; i++)
        {
            node = isTurned ? tour.Previous(node) : tour.Next(node);
            order[i] = (node, isTurned ? tour.TurnedEntryOf(node) : tour.EntryOf(node));
        }

        return order;
    }
}
