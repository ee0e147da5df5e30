using Engraver.Samples.Geometry;

namespace Engraver.Samples.Dxf;

internal sealed record CircleEntity(string Layer, Point Centre, double Radius) : DxfEntity(Layer);
