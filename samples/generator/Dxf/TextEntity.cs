using Engraver.Samples.Geometry;

namespace Engraver.Samples.Dxf;

internal sealed record TextEntity(string Layer, Point At, double Height, string Text) : DxfEntity(Layer);
