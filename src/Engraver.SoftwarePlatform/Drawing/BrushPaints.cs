using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paints;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>Makes paints from brushes. Pictures made for them live until the drawing context ends.</summary>
internal sealed class BrushPaints : IDisposable
{
    private readonly List<IDisposable> _pictures = [];

    /// <param name="area">The rectangle that relative coordinates of the brush refer to.</param>
    /// <returns>Null when nothing would be visible.</returns>
    public Paint? Create(IBrush brush, Rect area, double opacity, in Matrix transform, RenderOptions options)
    {
        var total = opacity * brush.Opacity;
        if (total <= 0)
            return null;
        if (brush is ISolidColorBrush solid)
        {
            var color = PixelArithmetic.Premultiplied(solid.Color, total);
            return color >> 24 == 0 ? null : new SolidPaint(color);
        }
        var toDevice = OwnTransform(brush, area) * transform;
        if (!toDevice.TryInvert(out var toBrush))
            return null;
        return brush is IGradientBrush gradient
            ? Gradient(gradient, area, total, toBrush)
            : new TilePaints(_pictures).Create(brush, area, total, toDevice, BitmapDrawing.IsSmooth(options));
    }

    public void Dispose()
    {
        foreach (var picture in _pictures)
            picture.Dispose();
        _pictures.Clear();
    }

    private static Matrix OwnTransform(IBrush brush, Rect area)
    {
        if (brush.Transform is not { } transform)
            return Matrix.Identity;
        var origin = brush.TransformOrigin.ToPixels(area);
        return Matrix.CreateTranslation(-origin.X, -origin.Y) * transform.Value * Matrix.CreateTranslation(origin.X, origin.Y);
    }

    private static Paint? Gradient(IGradientBrush brush, Rect area, double opacity, in Matrix toBrush)
    {
        if (brush.GradientStops.Count == 0)
            return null;
        var table = new GradientTable(brush.GradientStops, brush.SpreadMethod, opacity);
        switch (brush)
        {
            case ILinearGradientBrush linear:
                return new LinearGradientPaint(table, toBrush, linear.StartPoint.ToPixels(area), linear.EndPoint.ToPixels(area));
            case IRadialGradientBrush radial:
                return Radial(table, radial, area, toBrush);
            case IConicGradientBrush conic:
                return new ConicGradientPaint(table, toBrush, conic.Center.ToPixels(area), conic.Angle);
            default:
                return null;
        }
    }

    private static Paint Radial(GradientTable table, IRadialGradientBrush brush, Rect area, in Matrix toBrush)
    {
        double radiusX = brush.RadiusX.ToValue(area.Width), radiusY = brush.RadiusY.ToValue(area.Height);
        if (radiusX <= 0 || radiusY <= 0)
            return new SolidPaint(table.Last);
        return new RadialGradientPaint(table, toBrush, brush.Center.ToPixels(area), brush.GradientOrigin.ToPixels(area), radiusX, radiusY);
    }
}
