namespace Engraver.Samples.Dxf;

/// <summary>A block definition. Entities on layer "0" take the layer of the INSERT.</summary>
internal sealed record DxfBlock(string Name, IReadOnlyList<DxfEntity> Entities);
