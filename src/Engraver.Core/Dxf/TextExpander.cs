using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf;

/// <summary>Puts the texts of blocks into the drawing, once for every copy, as far as the limit goes: texts are not cut, so beyond it they are left out and counted only.</summary>
internal sealed class TextExpander(IReadOnlyDictionary<int, Block> blocks, LayerTable layers, CancellationToken cancellation)
{
    /// <summary>Placed texts and the inserts on the way to them.</summary>
    private const int MostSteps = 1_000_000;

    private long _steps;

    public List<PlacedText> Texts { get; } = [];

    /// <summary>True once texts were left out.</summary>
    public bool LeftOut { get; private set; }

    public void Add(PlacedText text)
    {
        if (++_steps <= MostSteps) Texts.Add(text);
        else LeftOut = true;
    }

    /// <summary>Places the texts of an insert of model space. Its block has been weighed.</summary>
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
        PlaceCopies(insert, block, Placement.Identity, insert.Layer, hidden: false);
    }

    private void PlaceCopies(in BlockInsert insert, Block block, in Placement outer, int layer, bool hidden)
    {
        cancellation.ThrowIfCancellationRequested();
        hidden |= insert.Invisible || layers.IsFrozen(layer);
        for (var row = 0; row < insert.Rows; row++)
        {
            for (var column = 0; column < insert.Columns; column++) Place(block, outer.After(insert.Copy(column, row, block.BasePoint)), layer, hidden);
        }
    }

    private void Place(Block block, in Placement at, int layer, bool hidden)
    {
        foreach (var text in block.Texts)
        {
            var placed = PlacedTexts.Placed(text, at) with { Layer = Effective(text.Layer, layer), Hidden = text.Hidden || hidden };
            if (PlacedTexts.IsInRange(placed)) Texts.Add(placed);
        }

        foreach (var nested in block.Inserts)
        {
            if (nested.Obstacle is null && blocks[nested.Insert.Block] is { Weight.TextSteps: > 0 } child) PlaceCopies(nested.Insert, child, at, Effective(nested.Insert.Layer, layer), hidden);
        }
    }

    private int Effective(int layer, int layerOfInsert) => layer == layers.Zero ? layerOfInsert : layer;
}
