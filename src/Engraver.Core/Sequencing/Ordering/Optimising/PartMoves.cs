namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Or-opt: one to three nodes move to another place of the tour, in either direction, and so does a contour with all that it encloses.</summary>
internal sealed class PartMoves<T>(Tour tour, TourLimits limits, Neighbors neighbors, TravelCosts<T> costs)
    where T : struct, ITravelMeasure
{
    private const int MaxShort = 3;

    /// <summary>Largest number of nodes of a block.</summary>
    private const int MaxBlock = 1000;

    /// <summary>Number of enclosing contours whose blocks are tried.</summary>
    private const int MaxLevels = 4;

    /// <summary>Finds the best change that moves a part that starts or ends with this node.</summary>
    public void Find(int node, ref TourChange best)
    {
        if (node == 0) return;
        TrySingle(node, ref best);
        var (first, last) = (node, node);
        for (var length = 2; length <= MaxShort && length + 2 < tour.Count; length++)
        {
            if (last != 0) last = tour.Next(last);
            if (last != 0) TryFromFirst(node, last, length, isTurnable: true, ref best);
            if (first != 0) first = tour.Previous(first);
            if (first != 0) TryFromLast(first, node, length, isTurnable: true, ref best);
        }

        if (limits.IsConstrained) TryBlocks(node, ref best);
    }

    private void TrySingle(int node, ref TourChange best)
    {
        var (previous, next) = (tour.Previous(node), tour.Next(node));
        var removed = costs.Link(previous, node) + costs.Link(node, next) - costs.Link(previous, next);
        if (removed <= best.Gain) return;
        foreach (var (other, cost) in neighbors.Of(node))
        {
            if (cost >= removed) return;
            if (other != previous) TrySingle(node, other, tour.Next(other), previous, removed, ref best);
            if (other != next) TrySingle(node, tour.Previous(other), other, previous, removed, ref best);
        }
    }

    private void TrySingle(int node, int after, int before, int previous, double removed, ref TourChange best)
    {
        if (after == node || before == node) return;
        var room = removed + costs.Link(after, before);
        if (room <= best.Gain) return;
        var (cost, entry) = costs.BestBetween(node, after, before);
        if (room - cost > best.Gain && limits.CanSwap(previous, node, after)) best = new TourChange(TourChangeKind.MoveOne, node, node, after, entry, room - cost);
    }

    private void TryFromFirst(int first, int last, int length, bool isTurnable, ref TourChange best)
    {
        var (previous, next) = (tour.Previous(first), tour.Next(last));
        var removed = costs.Link(previous, first) + costs.Link(last, next) - costs.Link(previous, next);
        if (removed <= best.Gain) return;
        foreach (var (other, cost) in neighbors.Of(first))
        {
            if (cost >= removed) return;
            if (tour.StepsBetween(first, other) < length) continue;
            if (other != previous && tour.Next(other) is var before)
            {
                var gain = removed + costs.Link(other, before) - costs.Link(other, first) - costs.Link(last, before);
                if (gain > best.Gain && limits.CanSwap(previous, last, other)) best = new TourChange(TourChangeKind.Move, first, last, other, 0, gain);
            }

            if (isTurnable && other != next && tour.Previous(other) is var after)
            {
                var gain = removed + costs.Link(after, other) - costs.LinkToTurned(after, last) - costs.LinkFromTurned(first, other);
                if (gain > best.Gain && CanTurn(first, last, previous, after)) best = new TourChange(TourChangeKind.MoveTurned, first, last, after, 0, gain);
            }
        }
    }

    private void TryFromLast(int first, int last, int length, bool isTurnable, ref TourChange best)
    {
        var (previous, next) = (tour.Previous(first), tour.Next(last));
        var removed = costs.Link(previous, first) + costs.Link(last, next) - costs.Link(previous, next);
        if (removed <= best.Gain) return;
        foreach (var (other, cost) in neighbors.Of(last))
        {
            if (cost >= removed) return;
            if (tour.StepsBetween(first, other) < length) continue;
            if (other != next && tour.Previous(other) is var after)
            {
                var gain = removed + costs.Link(after, other) - costs.Link(after, first) - costs.Link(last, other);
                if (gain > best.Gain && limits.CanSwap(previous, last, after)) best = new TourChange(TourChangeKind.Move, first, last, after, 0, gain);
            }

            if (isTurnable && other != previous && tour.Next(other) is var before)
            {
                var gain = removed + costs.Link(other, before) - costs.LinkToTurned(other, last) - costs.LinkFromTurned(first, before);
                if (gain > best.Gain && CanTurn(first, last, previous, other)) best = new TourChange(TourChangeKind.MoveTurned, first, last, other, 0, gain);
            }
        }
    }

    private bool CanTurn(int first, int last, int previous, int after) =>
        (!limits.IsConstrained || limits.CanReverse((tour.PositionOf(first), tour.PositionOf(last)))) && limits.CanSwap(previous, last, after);

    /// <summary>The blocks that end with this node, or that start with it and end with a contour around it.</summary>
    private void TryBlocks(int node, ref TourChange best)
    {
        if (limits.Precedence.Before(node).Length > 0) TryBlock(node, ref best);
        var around = node;
        for (var level = 0; level < MaxLevels && limits.Precedence.After(around) is [var outer, ..]; level++)
        {
            around = outer;
            if (!IsBound(tour.PositionOf(node) - 1, tour.PositionOf(around))) TryBlock(around, ref best);
        }
    }

    private void TryBlock(int outer, ref TourChange best)
    {
        var (end, length) = (tour.PositionOf(outer), 1);
        while (length < MaxBlock && IsBound(end - length, end)) length++;
        if (length == 1 || length + 2 >= tour.Count) return;
        var first = tour.At(end - length + 1);
        TryFromFirst(first, outer, length, isTurnable: false, ref best);
        TryFromLast(first, outer, length, isTurnable: false, ref best);
    }

    /// <summary>Whether the node at a position must come before one at a position up to the end of a block.</summary>
    private bool IsBound(int position, int end) => position > 0 && limits.LastBound(tour.At(position), end) >= 0;
}
