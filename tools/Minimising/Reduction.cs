namespace Engraver.Tools.Minimising;

/// <summary>Delta debugging (Zeller, Hildebrandt 2002): removes ever smaller runs of items as long as the fault still shows.</summary>
/// <param name="mostTrials">Maximum number of trials in total.</param>
internal sealed class Reduction(int mostTrials, CancellationToken cancellation)
{
    public int Trials { get; private set; }

    public bool IsExhausted => Trials >= mostTrials;

    /// <summary>A list that still shows the fault and from which no single item can be removed, unless the trials are used up; the order is kept.
    /// Deterministic.</summary>
    public List<T> Reduce<T>(List<T> items, Func<IReadOnlyList<T>, bool> shows)
    {
        for (var run = Math.Max(1, items.Count / 2); items.Count > 0;)
        {
            var before = items.Count;
            items = WithoutRuns(items, run, shows);
            if (IsExhausted || (run == 1 && items.Count == before)) break;
            if (run > 1) run = Math.Max(1, Math.Min(run / 2, items.Count));
        }

        return items;
    }

    /// <summary>Runs one counted trial; false if the fault does not show, or the trials are used up.</summary>
    public bool Try(Func<bool> shows)
    {
        cancellation.ThrowIfCancellationRequested();
        if (IsExhausted) return false;
        Trials++;
        return shows();
    }

    private List<T> WithoutRuns<T>(List<T> items, int run, Func<IReadOnlyList<T>, bool> shows)
    {
        for (var start = 0; start < items.Count && !IsExhausted;)
        {
            var rest = items[..start];
            rest.AddRange(items.Skip(start + run));
            if (Try(() => shows(rest))) items = rest;
            else start += run;
        }

        return items;
    }
}
