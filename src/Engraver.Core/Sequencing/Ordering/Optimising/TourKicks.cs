namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Random changes of a part of a tour, from which the local search finds other improvements. Each complies with the required order.</summary>
internal sealed class TourKicks<T>(Tour tour, TourLimits limits, LocalSearch<T> local, SearchRandom random)
    where T : struct, ITravelMeasure
{
    /// <summary>Largest number of nodes of an exchanged part.</summary>
    private const int MaxPart = 50;

    /// <summary>Where nodes have a required order, parts have up to 2, 4, ... nodes: most exchanges of long parts are not allowed.</summary>
    private const int PartSizes = 6;

    /// <summary>The same for reversed parts.</summary>
    private const int ReversalSizes = 6;

    /// <summary>Number of exchanges that are tried until one is allowed.</summary>
    private const int Trials = 10;

    /// <summary>One of so many kicks reverses a part, where nodes have a required order.</summary>
    private const int ReversalShare = 5;

    /// <summary>Changes the tour and requests improvements there.</summary>
    /// <returns>By how much the cost increased; null when no change was found.</returns>
    public double? Kick()
    {
        if (!limits.IsConstrained) return DoubleBridge(MaxPart);
        if (random.Below(ReversalShare) == 0) return Reverse(2 << random.Below(ReversalSizes));
        for (var trial = 0; trial < Trials; trial++)
        {
            if (DoubleBridge(2 << random.Below(PartSizes)) is { } cost) return cost;
        }

        return null;
    }

    private double? Reverse(int longest)
    {
        var length = 2 + random.Below(2 * longest);
        if (length > tour.Count - 2) return null;
        var first = 1 + random.Below(tour.Count - length - 1);
        return -local.Reverse(first, first + length - 1);
    }

    /// <summary>Puts three adjacent parts in reverse order, which no single change of the local search reverts.</summary>
    private double? DoubleBridge(int longest)
    {
        var left = tour.Count - 1;
        var first = 1 + random.Below(Math.Min(longest, left - 2));
        var second = 1 + random.Below(Math.Min(longest, left - first - 1));
        var third = 1 + random.Below(Math.Min(longest, left - first - second));
        var at = new Bridge(first, second, third) { First = random.Below(tour.Count - first - second - third) };
        return limits.IsConstrained && !(limits.CanSwapRanges(at.First + 1, at.LastB, at.LastD) && limits.CanSwapRanges(at.LastB + 1, at.LastC, at.LastD)) ? null : Exchange(at);
    }

    private double Exchange(in Bridge at)
    {
        var (before, b, c, d) = (tour.At(at.First), tour.At(at.First + 1), tour.At(at.LastB + 1), tour.At(at.LastC + 1));
        var (lastB, lastC, lastD) = (tour.At(at.LastB), tour.At(at.LastC), tour.At(at.LastD));
        var (after, costs) = (tour.Next(lastD), local.Costs);
        var old = costs.Link(before, b) + costs.Link(lastB, c) + costs.Link(lastC, d) + costs.Link(lastD, after);
        var added = costs.Link(before, d) + costs.Link(lastD, c) + costs.Link(lastC, b) + costs.Link(lastB, after);
        tour.Swap(before, lastB, lastD);
        if (tour.Next(before) == c) tour.Swap(before, lastC, lastD);
        else tour.Swap(b, d, c); // the tour is read in the other direction
        local.Enqueue(before, b, c, d);
        local.Enqueue(lastB, lastC, lastD, after);
        return added - old;
    }

    /// <param name="B">Number of nodes of the first part.</param>
    /// <param name="C">Number of nodes of the second part.</param>
    /// <param name="D">Number of nodes of the third part.</param>
    private readonly record struct Bridge(int B, int C, int D)
    {
        /// <summary>Position of the node before the parts.</summary>
        public int First { get; init; }

        public int LastB => First + B;

        public int LastC => LastB + C;

        public int LastD => LastC + D;
    }
}
