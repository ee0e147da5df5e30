namespace Engraver.Samples.Dxf;

/// <summary>All that one sample file holds. Layer "0" is always there and is not listed.</summary>
internal sealed record DxfDocument(DxfVersion Version, DrawingUnit Unit, IReadOnlyList<DxfLayer> Layers, IEnumerable<DxfEntity> Entities)
{
    public IReadOnlyList<DxfBlock> Blocks { get; init; } = [];

    /// <summary>Text styles besides STANDARD.</summary>
    public IReadOnlyList<DxfTextStyle> Styles { get; init; } = [];
}
