using Engraver.Samples.Geometry;

namespace Engraver.Samples.Dxf;

/// <summary>POLYLINE in an R12 file, LWPOLYLINE in later ones.</summary>
internal sealed record PolylineEntity(string Layer, IReadOnlyList<Vertex> Vertices, bool Closed) : DxfEntity(Layer)
{
    /// <remarks>A bulge belongs to the piece that leaves its vertex; backwards, that piece leaves the next one and bends the other way.</remarks>
    public override DxfEntity Reversed()
    {
        var count = Vertices.Count;
        var turned = Enumerable.Range(1, count).Select(i => new Vertex(Vertices[count - i].At, -Vertices[(2 * count - i - 1) % count].Bulge));
        return this with { Vertices = [.. turned] };
    }
}
