namespace Engraver.SoftwarePlatform.Rasteriser.Paints;

/// <summary>One premultiplied colour.</summary>
internal sealed class SolidPaint(uint color) : Paint
{
    public uint Color { get; } = color;

    public override bool IsOpaque => Color >> 24 == 255;

    public override void Shade(int x, int y, Span<uint> row) => row.Fill(Color);
}
