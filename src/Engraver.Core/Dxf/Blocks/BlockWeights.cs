using Engraver.Core.Diagnostics;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>Computes the weight of blocks before anything is expanded: how many curves, and which nested inserts cannot be followed. Linear in the number of
/// inserts.</summary>
internal sealed class BlockWeights(IReadOnlyDictionary<int, BlockDefinition> blocks)
{
    private readonly HashSet<BlockDefinition> _open = [];

    /// <summary>The weight of a block. A nested insert without a block, or of a block that contains itself, gets its obstacle and has no weight.</summary>
    public BlockWeight Weigh(BlockDefinition block)
    {
        if (block.Weight is { } known) return known;
        var path = new Stack<(BlockDefinition Block, int Next)>();
        path.Push((block, 0));
        _open.Add(block);
        while (path.TryPop(out var step))
        {
            var child = NextUnweighed(step.Block, ref step.Next);
            if (child is null)
            {
                _open.Remove(step.Block);
                step.Block.Weight = Total(step.Block);
                continue;
            }

            path.Push(step);
            path.Push((child, 0));
            _open.Add(child);
        }

        return block.Weight!;
    }

    private BlockDefinition? NextUnweighed(BlockDefinition block, ref int next)
    {
        for (; next < block.Inserts.Count; next++)
        {
            var nested = block.Inserts[next];
            if (!blocks.TryGetValue(nested.Insert.Block, out var child)) nested.Obstacle = DxfRules.MissingBlock;
            else if (_open.Contains(child)) nested.Obstacle = DxfRules.RecursiveBlock;
            else if (child.Weight is null) return child;
        }

        return null;
    }

    private BlockWeight Total(BlockDefinition block)
    {
        long curves = block.EndCurve - block.FirstCurve;
        var steps = BlockWeight.Sum(curves + block.Inserts.Count, block.ExtraSteps);
        long textSteps = block.Texts.Count;
        long pointSteps = block.Points.Count;
        long constructionSteps = block.Construction.Count;
        long inserts = 0;
        var loses = block.Issues.Exists(issue => issue.Refused);
        var annotations = new Dictionary<string, long>(block.Annotations, StringComparer.Ordinal);
        foreach (var nested in block.Inserts)
        {
            var child = nested.Obstacle is null ? blocks[nested.Insert.Block].Weight! : null;
            loses |= nested.Obstacle is not null || child!.HasUnfollowedInserts;
            if (nested.Obstacle is not null || child is null) continue;
            var copies = nested.Insert.Copies;
            curves = BlockWeight.Sum(curves, BlockWeight.Times(copies, child.Curves));
            inserts = BlockWeight.Sum(inserts, BlockWeight.Times(copies, BlockWeight.Sum(child.Inserts, 1)));
            if (child.Curves > 0) steps = BlockWeight.Sum(steps, BlockWeight.Times(copies, child.Steps + 1));
            if (child.TextSteps > 0) textSteps = BlockWeight.Sum(textSteps, BlockWeight.Times(copies, child.TextSteps + 1));
            if (child.PointSteps > 0) pointSteps = BlockWeight.Sum(pointSteps, BlockWeight.Times(copies, child.PointSteps + 1));
            if (child.ConstructionSteps > 0) constructionSteps = BlockWeight.Sum(constructionSteps, BlockWeight.Times(copies, child.ConstructionSteps + 1));
            AddAnnotations(annotations, child.Annotations, copies);
        }

        return new BlockWeight(curves, steps, loses, annotations, textSteps, constructionSteps) { PointSteps = pointSteps, Inserts = inserts };
    }

    /// <summary>Adds counts of texts and points, multiplied by the number of copies.</summary>
    public static void AddAnnotations(Dictionary<string, long> sums, IReadOnlyDictionary<string, long> added, long copies)
    {
        foreach (var (type, count) in added) sums[type] = BlockWeight.Sum(sums.GetValueOrDefault(type), BlockWeight.Times(copies, count));
    }
}
