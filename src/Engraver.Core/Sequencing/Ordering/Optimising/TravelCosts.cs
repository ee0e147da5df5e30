namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Costs of links between the nodes of a tour, as they are entered now.</summary>
internal sealed class TravelCosts<T>(OrderProblem problem, Tour tour, T measure)
    where T : struct, ITravelMeasure
{
    private readonly NodeEnds[] _ends = tour.Ends;

    /// <summary>From one node to the next.</summary>
    public double Link(int from, int to)
    {
        ref readonly var a = ref _ends[from];
        ref readonly var b = ref _ends[to];
        return measure.Of(b.InX - a.OutX, b.InY - a.OutY);
    }

    /// <summary>From one node to the next, which is turned.</summary>
    public double LinkToTurned(int from, int to)
    {
        ref readonly var a = ref _ends[from];
        ref readonly var b = ref _ends[to];
        return measure.Of(b.OutX - a.OutX, b.OutY - a.OutY);
    }

    /// <summary>From a node that is turned to the next.</summary>
    public double LinkFromTurned(int from, int to)
    {
        ref readonly var a = ref _ends[from];
        ref readonly var b = ref _ends[to];
        return measure.Of(b.InX - a.InX, b.InY - a.InY);
    }

    /// <summary>From one place to another.</summary>
    public double Between(in NodeEnds from, in NodeEnds to) => measure.Of(to.InX - from.OutX, to.InY - from.OutY);

    /// <summary>The least cost from one node through another to a third, and the entry with it.</summary>
    public (double Cost, int Entry) BestBetween(int node, int from, int to)
    {
        ref readonly var a = ref _ends[from];
        ref readonly var b = ref _ends[to];
        var kind = problem.KindOf(node);
        if (kind == NodeKind.Directed) return (Link(from, node) + Link(node, to), tour.EntryOf(node));
        if (kind == NodeKind.Open) return BestDirection(node, a, b);
        var (best, entry) = (double.PositiveInfinity, 0);
        var places = problem.PlacesOf(node);
        for (var i = 0; i < places.Length; i++)
        {
            var (x, y) = places[i];
            var cost = measure.Of(x - a.OutX, y - a.OutY) + measure.Of(b.InX - x, b.InY - y);
            if (cost < best) (best, entry) = (cost, i);
        }

        return (best, entry);
    }

    /// <summary>An entry of a node that was chosen for one direction of the tour, in that direction or the other.</summary>
    public int EntryFor(int node, int entry, bool isTurned) => isTurned && problem.KindOf(node) != NodeKind.Closed ? 1 - entry : entry;

    /// <summary>The cost of the whole tour.</summary>
    public double Total()
    {
        var total = 0.0;
        for (var position = 1; position < tour.Count; position++) total += Link(tour.At(position - 1), tour.At(position));
        return total + Link(tour.At(tour.Count - 1), tour.At(0));
    }

    private (double Cost, int Entry) BestDirection(int node, in NodeEnds from, in NodeEnds to)
    {
        var (ahead, entry) = (_ends[node], tour.EntryOf(node));
        var turned = ahead.Turned;
        var (now, other) = (Between(from, ahead) + Between(ahead, to), Between(from, turned) + Between(turned, to));
        return other < now ? (other, 1 - entry) : (now, entry);
    }
}
