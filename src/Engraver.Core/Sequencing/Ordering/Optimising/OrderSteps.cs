namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>The extent of a search by the number of strokes.</summary>
internal static class OrderSteps
{
    /// <summary>With more strokes the search would take longer than everything else, so there is none.</summary>
    private const int MaxSearched = 100_000;

    /// <summary>With more strokes only the first improvement is made.</summary>
    private const int MaxVaried = 20_000;

    /// <summary>The search for fewer strokes is also warmed up more.</summary>
    private const int MaxSmall = 200;

    private const int Least = 2000;
    private const int PerStroke = 25;
    private const int Most = 50_000;

    /// <summary>Steps for each stroke in the first round of a search that runs until it is stopped.</summary>
    private const int FirstRound = 100;

    /// <summary>Whether an order of so many strokes is improved at all.</summary>
    public static bool AreSearched(OrderSearch search, int strokes) => search.Steps is { } steps ? steps > 0 : strokes <= MaxSearched;

    /// <summary>The rounds of a search: at most four, or, of a search that runs until it is stopped, warmer and longer ones.</summary>
    /// <param name="isConstrained">Some strokes have a required order: such orders need more heat to change, and the reverse order is another one.</param>
    public static IEnumerable<OrderRound> Rounds(OrderSearch search, int strokes, bool isConstrained)
    {
        var (low, high) = isConstrained ? (0.3, 1.0) : (0.1, 0.3);
        return search.Steps is long.MaxValue
            ? Endless(Math.Max(Most, FirstRound * (long)strokes), low, high, isConstrained)
            : Limited(search.Steps ?? (strokes > MaxVaried ? 0 : Math.Min(Most, Least + ((long)PerStroke * strokes))), low, high, isConstrained, strokes <= MaxSmall);
    }

    private static IEnumerable<OrderRound> Limited(long steps, double low, double high, bool isConstrained, bool isSmall)
    {
        var part = steps / ((isConstrained ? 2 : 1) * (isSmall ? 2 : 1));
        yield return new OrderRound(part, low, false);
        if (isConstrained) yield return new OrderRound(part, low, true);
        if (!isSmall) yield break;
        yield return new OrderRound(part, high, false);
        if (isConstrained) yield return new OrderRound(part, high, true);
    }

    private static IEnumerable<OrderRound> Endless(long steps, double low, double high, bool isConstrained)
    {
        yield return new OrderRound(steps, 0.0, false);
        if (isConstrained) yield return new OrderRound(steps, low, true);
        for (; ; steps *= 2)
        {
            yield return new OrderRound(steps, low, false);
            yield return new OrderRound(steps, high, isConstrained);
        }
    }
}
