namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>The best entries of all nodes for the present order, by dynamic programming.</summary>
internal sealed class EntryPass<T>(OrderProblem problem, Tour tour, T measure)
    where T : struct, ITravelMeasure
{
    private readonly List<Option> _options = [];

    /// <summary>Sets the entries.</summary>
    public void Run()
    {
        _options.Clear();
        AddOptions(0);
        var (first, end, node) = (0, 1, tour.Next(0));
        for (var step = 1; step <= tour.Count; step++)
        {
            AddOptions(node);
            for (var option = end; option < _options.Count; option++) Link(option, first, end);
            (first, end, node) = (end, _options.Count, tour.Next(node));
        }

        for (var option = _options[^1].Before; option > 0; option = _options[option].Before) tour.SetEntry(_options[option].Node, _options[option].Entry);
    }

    private void AddOptions(int node)
    {
        if (problem.KindOf(node) == NodeKind.Directed)
        {
            _options.Add(new Option(node, tour.EntryOf(node), tour.Ends[node], 0.0, 0));
            return;
        }

        var count = problem.PlacesOf(node).Length;
        for (var entry = 0; entry < count; entry++) _options.Add(new Option(node, entry, problem.EndsOf(node, entry), 0.0, 0));
    }

    /// <summary>Links an option to the best one of the node before.</summary>
    private void Link(int option, int first, int end)
    {
        var (best, from, to) = (double.PositiveInfinity, first, _options[option].Ends);
        for (var before = first; before < end; before++)
        {
            var ends = _options[before].Ends;
            var cost = _options[before].Cost + measure.Of(to.InX - ends.OutX, to.InY - ends.OutY);
            if (cost < best) (best, from) = (cost, before);
        }

        _options[option] = _options[option] with { Cost = best, Before = from };
    }

    /// <param name="Cost">Of the tour up to the node.</param>
    /// <param name="Before">The option of the node before.</param>
    private readonly record struct Option(int Node, int Entry, NodeEnds Ends, double Cost, int Before);
}
