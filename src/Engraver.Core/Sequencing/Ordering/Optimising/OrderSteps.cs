namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>The extent of a search by the number of strokes.</summary>
internal static class OrderSteps
{
    /// <summary>With more strokes the search would take longer than everything else, so there is none.</summary>
    private const int MaxSearched = 100_000;

    /// <summary>With more strokes only the first improvement is made.</summary>
    private const int MaxVaried = 20_000;

    /// <summary>The search for fewer strokes is warmed up twice.</summary>
    private const int MaxSmall = 200;

    private const int Least = 2000;
    private const int PerStroke = 25;
    private const int Most = 50_000;

    /// <summary>Steps for each stroke in the first round of a search that runs until it is stopped.</summary>
    private const int FirstRound = 100;

    /// <summary>Whether an order of so many strokes is improved at all.</summary>
    public static bool AreSearched(OrderSearch search, int strokes) => search.Steps is { } steps ? steps > 0 : strokes <= MaxSearched;

    /// <summary>The rounds of a search: one, or three for few strokes; or, of a search that runs until it is stopped, a cold one and then warmer and longer ones.</summary>
    /// <param name="isConstrained">Some strokes have a required order: such orders need more heat to change.</param>
    public static IEnumerable<OrderRound> Rounds(OrderSearch search, int strokes, bool isConstrained)
    {
        var (low, high) = isConstrained ? (0.3, 1.0) : (0.1, 0.3);
        if (search.Steps is not long.MaxValue)
        {
            var all = search.Steps ?? (strokes > MaxVaried ? 0 : Math.Min(Most, Least + ((long)PerStroke * strokes)));
            var isSmall = strokes <= MaxSmall;
            yield return new OrderRound(isSmall ? all / 2 : all, low);
            if (!isSmall) yield break;
            yield return new OrderRound(all / 4, high);
            yield return new OrderRound(all / 4, low);
            yield break;
        }

        var steps = Math.Max(Most, FirstRound * (long)strokes);
        yield return new OrderRound(steps, 0.0);
        for (var isHigh = false; ; isHigh = !isHigh)
        {
            yield return new OrderRound(steps, isHigh ? high : low);
            if (isHigh) steps *= 2;
        }
    }
}
