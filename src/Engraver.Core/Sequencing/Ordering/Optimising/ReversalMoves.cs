namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>2-opt: two links are replaced by reversing what is between them. Where contours must stay in order, a contour
/// waits for those inside it.</summary>
internal sealed class ReversalMoves<T>(Tour tour, TourLimits limits, Neighbors neighbors, TravelCosts<T> costs)
    where T : struct, ITravelMeasure
{
    /// <summary>Largest number of nodes of a range in which some keep their order.</summary>
    private const int MaxOrderedRange = 1000;

    private readonly ReversedRange _reversed = new(tour, limits);

    /// <summary>Finds the best change that links a node to one of its neighbours.</summary>
    public void Find(int node, ref TourChange best)
    {
        var (next, previous) = (tour.Next(node), tour.Previous(node));
        var (ahead, behind) = (costs.Link(node, next), costs.Link(previous, node));
        foreach (var (other, cost) in neighbors.Of(node))
        {
            if (cost >= ahead && cost >= behind) break;
            if (other != next && cost < ahead && tour.Next(other) is var after && after != node)
            {
                var gain = ahead + costs.Link(other, after) - costs.LinkToTurned(node, other) - costs.LinkFromTurned(next, after);
                if (gain > best.Gain) Offer(node, next, other, after, gain, ref best);
            }

            if (other != previous && cost < behind && tour.Previous(other) is var before && before != node)
            {
                var gain = behind + costs.Link(before, other) - costs.LinkToTurned(previous, before) - costs.LinkFromTurned(node, other);
                if (gain > best.Gain) Offer(previous, node, before, other, gain, ref best);
            }
        }
    }

    /// <summary>Reverses a range of positions as far as the required order allows.</summary>
    /// <param name="queue">Receives the nodes with new neighbours.</param>
    /// <returns>By how much the cost decreased.</returns>
    public double ReverseOrdered(int first, int last, NodeQueue queue)
    {
        _reversed.Find(first, last);
        var gain = GainOf(first, last);
        queue.Add(tour.At(first - 1), tour.At(first), tour.At(last), tour.Next(tour.At(last)));
        var nodes = _reversed.Nodes;
        for (var i = 1; i < nodes.Count; i++)
        {
            var position = tour.PositionOf(nodes[i]) + 1;
            if (position <= last && tour.At(position) == nodes[i - 1]) continue;
            queue.Add(nodes[i - 1]);
            queue.Add(nodes[i]);
        }

        tour.Arrange(first, nodes, isTurned: true);
        return gain;
    }

    private void Offer(int a, int b, int c, int d, double gain, ref TourChange best)
    {
        if (limits.CanReverse(b, c, d, a))
        {
            best = new TourChange(TourChangeKind.Reverse, a, b, c, d, gain);
            return;
        }

        if (!limits.IsConstrained) return;
        var (first, last) = limits.RangeOf(b, c, d, a);
        if (last - first >= Math.Min(MaxOrderedRange, limits.MaxLength)) return;
        _reversed.Find(first, last);
        gain = GainOf(first, last);
        if (gain > best.Gain) best = new TourChange(TourChangeKind.ReverseOrdered, first, last, 0, 0, gain);
    }

    private double GainOf(int first, int last)
    {
        var (from, gain, behind) = (tour.Ends[tour.At(first - 1)], 0.0, tour.Next(tour.At(last)));
        for (var position = first; position <= last; position++)
        {
            var to = _reversed.EndsOf(_reversed.Nodes[position - first]);
            gain += costs.Link(tour.At(position - 1), tour.At(position)) - costs.Between(from, to);
            from = to;
        }

        return gain + costs.Link(tour.At(last), behind) - costs.Between(from, tour.Ends[behind]);
    }
}
