using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Blocks;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf.Text;

/// <summary>Adds the texts of blocks to the drawing, once for every copy.</summary>
internal sealed class TextExpander(IReadOnlyDictionary<int, BlockDefinition> blocks, LayerTable layers, CancellationToken cancellation) : CopyExpander<PlacedText>(blocks, layers, cancellation)
{
    private readonly LayerTable _layers = layers;

    protected override long StepsOf(BlockWeight weight) => weight.TextSteps;

    protected override IReadOnlyList<PlacedText> ContentOf(BlockDefinition block) => block.Texts;

    protected override bool TryPlace(PlacedText one, in Placement at, in InsertStyle style, out PlacedText placed)
    {
        placed = PlacedTexts.Placed(one, at) with { Layer = style.LayerOf(one.Layer, _layers), Hidden = one.Hidden || style.Hidden };
        return PlacedTexts.IsInRange(placed);
    }
}
