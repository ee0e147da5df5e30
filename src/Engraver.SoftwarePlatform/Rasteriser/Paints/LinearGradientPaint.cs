using Avalonia;

namespace Engraver.SoftwarePlatform.Rasteriser.Paints;

/// <summary>Colours change along the line from start to end, given in the brush's coordinates.</summary>
internal sealed class LinearGradientPaint(GradientTable table, Matrix toBrush, Point start, Point end) : Paint
{
    private readonly Vector _along = end - start;

    public override bool IsOpaque => table.IsOpaque;

    public override void Shade(int x, int y, Span<uint> row)
    {
        var length = _along.SquaredLength;
        if (length <= 0)
        {
            row.Fill(table.Last);
            return;
        }
        var first = new Point(x + 0.5, y + 0.5).Transform(toBrush) - start;
        var offset = Vector.Dot(first, _along) / length;
        var step = (toBrush.M11 * _along.X + toBrush.M12 * _along.Y) / length;
        if (Math.Abs(step) < 1e-12)
        {
            row.Fill(table[offset]);
            return;
        }
        for (var i = 0; i < row.Length; i++)
            row[i] = table[offset + i * step];
    }
}
