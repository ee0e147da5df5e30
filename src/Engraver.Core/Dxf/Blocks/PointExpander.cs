using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>Adds the points of blocks to the drawing, once for every copy.</summary>
internal sealed class PointExpander(IReadOnlyDictionary<int, BlockDefinition> blocks, LayerTable layers, BlockPathTable paths, CancellationToken cancellation) : CopyExpander<PlacedPoint>(blocks, layers, paths, cancellation)
{
    private readonly LayerTable _layers = layers;

    protected override long StepsOf(BlockWeight weight) => weight.PointSteps;

    protected override IReadOnlyList<PlacedPoint> ContentOf(BlockDefinition block) => block.Points;

    protected override bool TryPlace(PlacedPoint one, in Placement at, in InsertStyle style, out PlacedPoint placed)
    {
        var layer = style.LayerOf(one.Layer, _layers);
        placed = one with
        {
            Position = at.Apply(one.Position),
            Layer = layer,
            Colour = style.ColourOf(one.Colour, layer, _layers),
            Linetype = style.LinetypeOf(one.Linetype, layer, _layers),
            Hidden = one.Hidden || style.Hidden,
            BlockPath = style.Path,
        };
        return PlacedPoints.InRange(placed.Position);
    }
}
