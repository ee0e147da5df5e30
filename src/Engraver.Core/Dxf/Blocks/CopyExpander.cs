using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>Adds items that are only shown (texts, points) to the drawing, those of blocks once for every copy, up to a limit: beyond it they are only
/// counted.</summary>
internal abstract class CopyExpander<T>(IReadOnlyDictionary<int, BlockDefinition> blocks, LayerTable layers, BlockPathTable paths, CancellationToken cancellation) : IBlockVisitor
{
    /// <summary>Maximum number of items, with the inserts that lead to them, that are placed.</summary>
    private const int MaxSteps = 1_000_000;

    private readonly List<T> _placed = [];
    private BlockWalk? _walk;
    private long _steps;

    public IReadOnlyList<T> Placed => _placed;

    /// <summary>True after an item was left out.</summary>
    public bool LeftOut { get; private set; }

    public void Add(T one)
    {
        if (++_steps <= MaxSteps) _placed.Add(one);
        else LeftOut = true;
    }

    /// <summary>Places the items of an insert of model space. The weight of its block is known.</summary>
    public void Expand(in BlockInsert insert)
    {
        if (!blocks.TryGetValue(insert.Block, out var block) || block.Weight is not { } weight || StepsOf(weight) == 0) return;
        var steps = BlockWeight.Times(insert.Copies, StepsOf(weight));
        if (_steps + steps > MaxSteps)
        {
            LeftOut = true;
            return;
        }

        _steps += steps;
        (_walk ??= new BlockWalk(blocks, layers, paths, this, cancellation)).Through(insert, block);
    }

    public bool ShouldVisit(BlockWeight weight) => StepsOf(weight) > 0;

    public int Enter(BlockDefinition block, in Placement at, in InsertStyle style, int around)
    {
        foreach (var one in ContentOf(block))
        {
            if (TryPlace(one, at, style, out var placed)) _placed.Add(placed);
        }

        return 0;
    }

    public void Curves(int first, int end, in Placement at, in InsertStyle style)
    {
    }

    /// <summary>The cost of one copy of a block.</summary>
    protected abstract long StepsOf(BlockWeight weight);

    /// <summary>The items directly in a block.</summary>
    protected abstract IReadOnlyList<T> ContentOf(BlockDefinition block);

    /// <summary>One item in the world; false when it is out of range.</summary>
    protected abstract bool TryPlace(T one, in Placement at, in InsertStyle style, out T placed);
}
