using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Rasteriser.Paths;

/// <summary>How a line is drawn. Dash lengths and their offset are in line widths, as in Avalonia.</summary>
internal sealed record StrokeStyle(
    double Width,
    PenLineCap Cap = PenLineCap.Flat,
    PenLineJoin Join = PenLineJoin.Miter,
    double MiterLimit = 10,
    IReadOnlyList<double>? Dashes = null,
    double DashOffset = 0)
{
    public bool IsDashed => Dashes is { Count: > 0 };

    public static StrokeStyle From(IPen pen) =>
        new(pen.Thickness, pen.LineCap, pen.LineJoin, pen.MiterLimit, pen.DashStyle?.Dashes, pen.DashStyle?.Offset ?? 0);
}
