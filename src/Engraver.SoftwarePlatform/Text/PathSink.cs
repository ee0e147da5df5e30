using Avalonia;
using Engraver.Fonts;
using Engraver.Fonts.OpenType.Outlines;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Adds the contours of a glyph to a path.</summary>
internal sealed class PathSink(VectorPath path) : IOutlineSink
{
    public void MoveTo(FontPoint start) => path.MoveTo(PointOf(start));

    public void LineTo(FontPoint end) => path.LineTo(PointOf(end));

    public void QuadraticTo(FontPoint control, FontPoint end) => path.QuadraticTo(PointOf(control), PointOf(end));

    public void CubicTo(FontPoint control1, FontPoint control2, FontPoint end) => path.CubicTo(PointOf(control1), PointOf(control2), PointOf(end));

    public void Close() => path.Close();

    private static Point PointOf(FontPoint point) => new(point.X, point.Y);
}
