using Avalonia;

namespace Engraver.SoftwarePlatform.Rasteriser.Paints;

/// <summary>Colours change around the centre, clockwise from <paramref name="angleDegrees"/>; 0 degrees is up.</summary>
internal sealed class ConicGradientPaint(GradientTable table, Matrix toBrush, Point centre, double angleDegrees) : Paint
{
    public override bool IsOpaque => table.IsOpaque;

    public override void Shade(int x, int y, Span<uint> row)
    {
        var first = new Point(x + 0.5, y + 0.5).Transform(toBrush) - centre;
        var turn = 0.25 - angleDegrees / 360;
        for (var i = 0; i < row.Length; i++)
        {
            var offset = Math.Atan2(first.Y + i * toBrush.M12, first.X + i * toBrush.M11) / (2 * Math.PI) + turn;
            row[i] = table[offset - Math.Floor(offset)];
        }
    }
}
