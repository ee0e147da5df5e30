using Engraver.Samples.Geometry;

namespace Engraver.Samples.Dxf;

internal sealed record LineEntity(string Layer, Point From, Point To) : DxfEntity(Layer)
{
    public override DxfEntity Reversed() => this with { From = To, To = From };
}
