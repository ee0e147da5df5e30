using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Blocks;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Text;

/// <summary>Adds the texts of blocks to the drawing, once for every copy.</summary>
internal sealed class TextExpander(IReadOnlyDictionary<int, BlockDefinition> blocks, LayerTable layers, BlockPathTable paths, CancellationToken cancellation) : CopyExpander<PlacedText>(blocks, layers, paths, cancellation)
{
    private readonly LayerTable _layers = layers;

    protected override long StepsOf(BlockWeight weight) => weight.TextSteps;

    protected override IReadOnlyList<PlacedText> ContentOf(BlockDefinition block) => block.Texts;

    protected override bool TryPlace(PlacedText one, in Placement at, in InsertStyle style, out PlacedText placed)
    {
        var layer = style.LayerOf(one.Layer, _layers);
        placed = PlacedTexts.Placed(one, at) with
        {
            Layer = layer,
            Hidden = one.Hidden || style.Hidden,
            Colour = style.ColourOf(one.Colour, layer, _layers),
            Lineweight = style.LineweightOf(one.Lineweight, layer, _layers),
            Inserts = at.After(one.Inserts),
            BlockPath = style.Path,
        };
        return PlacedTexts.IsInRange(placed);
    }
}
