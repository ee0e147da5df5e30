using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Blocks;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf.Text;

/// <summary>Puts the texts of blocks into the drawing, once for every copy, up to a limit: texts are not cut, so beyond it they are only counted.</summary>
internal sealed class TextExpander(IReadOnlyDictionary<int, BlockDefinition> blocks, LayerTable layers, CancellationToken cancellation) : IBlockVisitor
{
    /// <summary>Most texts, with the inserts that lead to them, that are placed.</summary>
    private const int MostSteps = 1_000_000;

    private BlockWalk? _walk;
    private long _steps;

    public List<PlacedText> Texts { get; } = [];

    /// <summary>True once texts were left out.</summary>
    public bool LeftOut { get; private set; }

    public void Add(PlacedText text)
    {
        if (++_steps <= MostSteps) Texts.Add(text);
        else LeftOut = true;
    }

    /// <summary>Places the texts of an insert of model space. The weight of its block is known.</summary>
    public void Expand(in BlockInsert insert)
    {
        if (!blocks.TryGetValue(insert.Block, out var block) || block.Weight is not { TextSteps: > 0 } weight) return;
        var steps = BlockWeight.Times(insert.Copies, weight.TextSteps);
        if (_steps + steps > MostSteps)
        {
            LeftOut = true;
            return;
        }

        _steps += steps;
        (_walk ??= new BlockWalk(blocks, layers, this, cancellation)).Through(insert, block);
    }

    public bool Wants(BlockWeight weight) => weight.TextSteps > 0;

    public void Enter(BlockDefinition block, in Placement at, in InsertStyle style)
    {
        foreach (var text in block.Texts)
        {
            var placed = PlacedTexts.Placed(text, at) with { Layer = style.LayerOf(text.Layer, layers), Hidden = text.Hidden || style.Hidden };
            if (PlacedTexts.IsInRange(placed)) Texts.Add(placed);
        }
    }

    public void Curves(int first, int end, in Placement at, in InsertStyle style)
    {
    }
}
