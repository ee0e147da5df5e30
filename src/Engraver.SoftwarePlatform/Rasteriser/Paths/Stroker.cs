using Avalonia;
using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Rasteriser.Paths;

/// <summary>Makes the outline of a drawn line; it is filled by the non-zero rule.</summary>
internal static class Stroker
{
    private const double FlatteningTolerance = 0.03;

    /// <param name="scale">Device pixels per unit of the path: curves are made as fine as that needs.</param>
    public static VectorPath Stroke(VectorPath path, StrokeStyle style, double scale)
    {
        var outline = new VectorPath(FillRule.NonZero);
        if (!(style.Width > 0))
            return outline;
        var usedScale = Math.Max(scale, 1e-6);
        var pen = new StrokeOutline(outline, style, usedScale);
        var dashes = style.IsDashed ? new DashCutter(style) : null;
        foreach (var figure in PathFlattener.Flatten(path, Matrix.Identity, FlatteningTolerance / usedScale))
        {
            if (dashes is null)
            {
                pen.Draw(figure);
                continue;
            }
            foreach (var dash in dashes.Cut(figure))
                pen.Draw(WithoutRepeats(dash));
        }
        return outline;
    }

    private static Polyline WithoutRepeats(Polyline dash)
    {
        for (var i = dash.Points.Count - 1; i > 0; i--)
        {
            if ((dash.Points[i] - dash.Points[i - 1]).SquaredLength < 1e-18)
                dash.Points.RemoveAt(i);
        }
        return dash;
    }
}
