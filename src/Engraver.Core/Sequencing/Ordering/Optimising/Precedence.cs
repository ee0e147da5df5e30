namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>For each node the nodes that must come after it and those that must come before it.</summary>
internal sealed class Precedence
{
    private readonly int[] _afterStarts;
    private readonly int[] _after;
    private readonly int[] _beforeStarts;
    private readonly int[] _before;

    public Precedence(OrderProblem problem)
    {
        (_afterStarts, _after) = Grouped(problem.Count, problem.Pairs.Select(pair => (pair.Before, pair.After)));
        (_beforeStarts, _before) = Grouped(problem.Count, problem.Pairs.Select(pair => (pair.After, pair.Before)));
    }

    public ReadOnlySpan<int> After(int node) => _after.AsSpan(_afterStarts[node].._afterStarts[node + 1]);

    public ReadOnlySpan<int> Before(int node) => _before.AsSpan(_beforeStarts[node].._beforeStarts[node + 1]);

    private static (int[] Starts, int[] Items) Grouped(int count, IEnumerable<(int Key, int Item)> pairs)
    {
        var starts = new int[count + 1];
        foreach (var (key, _) in pairs) starts[key + 1]++;
        for (var key = 0; key < count; key++) starts[key + 1] += starts[key];
        var (items, next) = (new int[starts[count]], starts.ToArray());
        foreach (var (key, item) in pairs) items[next[key]++] = item;
        return (starts, items);
    }
}
