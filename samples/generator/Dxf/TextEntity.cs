using Engraver.Samples.Geometry;

namespace Engraver.Samples.Dxf;

internal sealed record TextEntity(string Layer, Point At, double Height, string Text) : DxfEntity(Layer)
{
    /// <summary>Null for STANDARD.</summary>
    public string? Style { get; init; }

    /// <summary>True when the text is centred on its place.</summary>
    public bool Centred { get; init; }
}
