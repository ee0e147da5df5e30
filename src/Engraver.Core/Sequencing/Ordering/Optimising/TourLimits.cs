namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Which changes of a tour comply with the required order of its nodes, and are short enough.</summary>
internal sealed class TourLimits(OrderProblem problem, Tour tour)
{
    private readonly Precedence _precedence = new(problem);
    private readonly bool[] _isDirected = [.. Enumerable.Range(0, problem.Count).Select(node => problem.KindOf(node) == NodeKind.Directed)];

    public bool IsConstrained { get; } = problem.IsConstrained;

    /// <summary>Largest number of nodes that a change may rearrange.</summary>
    public int MaxLength { get; set; } = int.MaxValue;

    public Precedence Precedence => _precedence;

    public bool IsDirected(int node) => _isDirected[node];

    /// <summary>The positions that 2-opt reverses in place of the path between two nodes: never the tool with constraints.</summary>
    public (int First, int Last) RangeOf(int b, int c, int d, int a)
    {
        var (first, last) = (tour.PositionOf(b), tour.PositionOf(c));
        return first != 0 && first <= last ? (first, last) : (tour.PositionOf(d), tour.PositionOf(a));
    }

    /// <summary>Whether the path from b to c, or the rest of the tour, can be reversed.</summary>
    public bool CanReverse(int b, int c, int d, int a)
    {
        if (IsConstrained) return CanReverse(RangeOf(b, c, d, a));
        var length = tour.StepsBetween(b, c) + 1;
        return Math.Min(length, tour.Count - length) <= MaxLength;
    }

    /// <summary>Whether a range of positions without the tool can be reversed.</summary>
    public bool CanReverse((int First, int Last) range)
    {
        if (range.Last - range.First >= MaxLength) return false;
        for (var position = range.First; position <= range.Last; position++)
        {
            var node = tour.At(position);
            if (_isDirected[node] || IsBoundWithin(node, position, range.Last)) return false;
        }

        return true;
    }

    /// <summary>Whether the nodes behind a up to d and those behind d up to e can change places; in the order of the tour.</summary>
    public bool CanSwap(int a, int d, int e)
    {
        if (!IsConstrained)
        {
            var longest = Math.Max(Math.Max(tour.StepsBetween(a, d), tour.StepsBetween(d, e)), tour.StepsBetween(e, a));
            return tour.Count - longest <= MaxLength;
        }

        var (low, middle, high) = (tour.PositionOf(a), tour.PositionOf(d), tour.PositionOf(e));
        while (low > middle || low > high) (low, middle, high) = (middle, high, low);
        return CanSwapRanges(low + 1, middle, high);
    }

    /// <summary>Whether two adjacent ranges of positions can change places.</summary>
    public bool CanSwapRanges(int first, int middle, int last)
    {
        if (last - first >= MaxLength) return false;
        if (middle - first < last - middle)
        {
            for (var position = first; position <= middle; position++)
            {
                if (HasAny(_precedence.After(tour.At(position)), middle + 1, last)) return false;
            }

            return true;
        }

        for (var position = middle + 1; position <= last; position++)
        {
            if (HasAny(_precedence.Before(tour.At(position)), first, middle)) return false;
        }

        return true;
    }

    /// <summary>The last position, up to a limit, at which a node has to come after this one; -1 for none.</summary>
    public int LastBound(int node, int limit)
    {
        var last = -1;
        foreach (var after in _precedence.After(node))
        {
            if (tour.PositionOf(after) is var position && position <= limit) last = Math.Max(last, position);
        }

        return last;
    }

    private bool IsBoundWithin(int node, int from, int to) => HasAny(_precedence.After(node), from, to);

    private bool HasAny(ReadOnlySpan<int> nodes, int first, int last)
    {
        foreach (var node in nodes)
        {
            if (tour.PositionOf(node) is var position && position >= first && position <= last) return true;
        }

        return false;
    }
}
