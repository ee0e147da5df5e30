using Engraver.Core.Diagnostics;

namespace Engraver.Core.Dxf;

/// <summary>Weighs blocks before anything is expanded: how many curves, which nested inserts cannot be followed. Linear in the number of inserts.</summary>
internal sealed class BlockScale(IReadOnlyDictionary<int, Block> blocks)
{
    private readonly HashSet<Block> _open = [];

    /// <summary>The weight of a block; nested inserts that lead nowhere or back get their obstacle and weigh nothing.</summary>
    public BlockWeight Weigh(Block block)
    {
        if (block.Weight is { } known) return known;
        var path = new Stack<(Block Block, int Next)>();
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

    private Block? NextUnweighed(Block block, ref int next)
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

    private BlockWeight Total(Block block)
    {
        long curves = block.EndCurve - block.FirstCurve;
        var steps = BlockWeight.Sum(curves + block.Inserts.Count, block.ExtraSteps);
        long textSteps = block.Texts.Count;
        long constructionSteps = block.Construction.Count;
        var loses = block.Troubles.Exists(trouble => trouble.Refused);
        var annotations = new Dictionary<string, long>(block.Annotations, StringComparer.Ordinal);
        foreach (var nested in block.Inserts)
        {
            var child = nested.Obstacle is null ? blocks[nested.Insert.Block].Weight! : null;
            loses |= nested.Obstacle is not null || child!.Loses;
            if (nested.Obstacle is not null || child is null) continue;
            var copies = nested.Insert.Copies;
            curves = BlockWeight.Sum(curves, BlockWeight.Times(copies, child.Curves));
            if (child.Curves > 0) steps = BlockWeight.Sum(steps, BlockWeight.Times(copies, child.Steps + 1));
            if (child.TextSteps > 0) textSteps = BlockWeight.Sum(textSteps, BlockWeight.Times(copies, child.TextSteps + 1));
            if (child.ConstructionSteps > 0) constructionSteps = BlockWeight.Sum(constructionSteps, BlockWeight.Times(copies, child.ConstructionSteps + 1));
            AddAnnotations(annotations, child.Annotations, copies);
        }

        return new BlockWeight(curves, steps, loses, annotations, textSteps, constructionSteps);
    }

    /// <summary>Adds texts and points, a copy's amount times the copies.</summary>
    public static void AddAnnotations(Dictionary<string, long> sums, IReadOnlyDictionary<string, long> added, long copies)
    {
        foreach (var (type, count) in added) sums[type] = BlockWeight.Sum(sums.GetValueOrDefault(type), BlockWeight.Times(copies, count));
    }
}
