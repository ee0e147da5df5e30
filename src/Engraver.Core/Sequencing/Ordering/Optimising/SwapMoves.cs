namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Or-3opt: two adjacent parts of any length change places and keep their directions.</summary>
internal sealed class SwapMoves<T>(Tour tour, TourLimits limits, Neighbors neighbors, TravelCosts<T> costs)
    where T : struct, ITravelMeasure
{
    /// <summary>Number of neighbours that are tried for each of the two new links.</summary>
    private readonly int _breadth = neighbors.Capacity * 6 / 10;

    /// <summary>Finds the best change that links this node to one of its neighbours.</summary>
    public void Find(int a, ref TourChange best)
    {
        var b = tour.Next(a);
        var ahead = costs.Link(a, b);
        var near = neighbors.Of(a);
        for (var i = 0; i < near.Length && i < _breadth && near[i].Cost < ahead; i++)
        {
            var c = near[i].Node;
            var d = tour.Previous(c);
            var first = ahead - costs.Link(a, c);
            if (c == b || d == a || first <= 0.0) continue;
            FindSecond(a, b, c, d, first + costs.Link(d, c), ref best);
        }
    }

    private void FindSecond(int a, int b, int c, int d, double open, ref TourChange best)
    {
        var near = neighbors.Of(b);
        var length = tour.StepsBetween(b, d);
        for (var i = 0; i < near.Length && i < _breadth; i++)
        {
            var (e, cost) = near[i];
            if (open - cost <= best.Gain - MaxLinkGain(e)) continue;
            if (e == a || tour.StepsBetween(b, e) <= length) continue;
            var f = tour.Next(e);
            var gain = open + costs.Link(e, f) - costs.Link(e, b) - costs.Link(d, f);
            if (gain > best.Gain && limits.CanSwap(a, d, e)) best = new TourChange(TourChangeKind.Swap, a, d, e, 0, gain);
        }
    }

    /// <summary>The most that is saved by removing the link behind a node.</summary>
    private double MaxLinkGain(int node) => costs.Link(node, tour.Next(node));
}
