using Avalonia;

namespace Engraver.SoftwarePlatform.Rasteriser.Paints;

/// <summary>Offset 0 at the focus, 1 on the ellipse around the centre.</summary>
internal sealed class RadialGradientPaint(GradientTable table, Matrix toBrush, Point centre, Point focus, double radiusX, double radiusY) : Paint
{
    /// <summary>Largest distance of the focus from the centre, in radii: on or outside the circle it would leave areas without colour, so it is moved
    /// inside.</summary>
    private const double MaxFocusDistance = 0.9999;

    private readonly Vector _focus = Inside(new Vector((focus.X - centre.X) / radiusX, (focus.Y - centre.Y) / radiusY));

    public override bool IsOpaque => table.IsOpaque;

    public override void Shade(int x, int y, Span<uint> row)
    {
        var toCircle = toBrush * Matrix.CreateTranslation(-centre.X, -centre.Y) * Matrix.CreateScale(1 / radiusX, 1 / radiusY);
        var first = new Point(x + 0.5, y + 0.5).Transform(toCircle);
        var constant = 1 - _focus.SquaredLength;
        for (var i = 0; i < row.Length; i++)
        {
            double u = first.X + i * toCircle.M11 - _focus.X, v = first.Y + i * toCircle.M12 - _focus.Y;
            var away = u * u + v * v;
            var along = _focus.X * u + _focus.Y * v;
            row[i] = table[(along + Math.Sqrt(along * along + away * constant)) / constant];
        }
    }

    private static Vector Inside(Vector focus) => focus.Length > MaxFocusDistance ? focus * (MaxFocusDistance / focus.Length) : focus;
}
