using Engraver.Samples.Geometry;

namespace Engraver.Samples.Dxf;

/// <summary>A circular arc, always counter-clockwise from <paramref name="Start"/> to <paramref name="End"/>, in degrees of any turn.</summary>
internal sealed record ArcEntity(string Layer, Point Centre, double Radius, double Start, double End) : DxfEntity(Layer);
