using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>Adds the points of blocks to the drawing, once for every copy.</summary>
internal sealed class PointExpander(IReadOnlyDictionary<int, BlockDefinition> blocks, LayerTable layers, CancellationToken cancellation) : CopyExpander<PlacedPoint>(blocks, layers, cancellation)
{
    private readonly LayerTable _layers = layers;

    protected override long StepsOf(BlockWeight weight) => weight.PointSteps;

    protected override IReadOnlyList<PlacedPoint> ContentOf(BlockDefinition block) => block.Points;

    protected override bool TryPlace(PlacedPoint one, in Placement at, in InsertStyle style, out PlacedPoint placed)
    {
        var layer = style.LayerOf(one.Layer, _layers);
        placed = new PlacedPoint(at.Apply(one.Position), layer, style.ColourOf(one.Colour, layer, _layers), one.Hidden || style.Hidden);
        return PlacedPoints.InRange(placed.Position);
    }
}
