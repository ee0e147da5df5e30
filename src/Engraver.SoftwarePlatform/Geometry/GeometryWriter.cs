using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Geometry;

/// <summary>Writes figures into the stroke path, and into a separate fill path as soon as one figure is not to be filled.</summary>
/// <param name="strokePath">Receives all figures.</param>
/// <param name="finish">Called at the end with the path to fill.</param>
internal sealed class GeometryWriter(VectorPath strokePath, Action<VectorPath> finish) : IStreamGeometryContextImpl
{
    private VectorPath? _fillPath;
    private bool _isFilled = true;

    public void BeginFigure(Point startPoint, bool isFilled = true)
    {
        if (!isFilled)
            _fillPath ??= strokePath.Transformed(Matrix.Identity);
        _isFilled = isFilled;
        Write(path => path.MoveTo(startPoint));
    }

    public void LineTo(Point endPoint, bool isStroked = true) => Write(path => path.LineTo(endPoint));

    public void CubicBezierTo(Point controlPoint1, Point controlPoint2, Point endPoint, bool isStroked = true) =>
        Write(path => path.CubicTo(controlPoint1, controlPoint2, endPoint));

    public void QuadraticBezierTo(Point controlPoint, Point endPoint, bool isStroked = true) => Write(path => path.QuadraticTo(controlPoint, endPoint));

    public void ArcTo(Point point, Size size, double rotationAngle, bool isLargeArc, SweepDirection sweepDirection, bool isStroked = true) =>
        Write(path => path.ArcTo(point, size, rotationAngle, isLargeArc, sweepDirection == SweepDirection.Clockwise));

    public void EndFigure(bool isClosed)
    {
        if (isClosed)
            Write(path => path.Close());
    }

    public void SetFillRule(FillRule fillRule)
    {
        strokePath.FillRule = fillRule;
        if (_fillPath is not null)
            _fillPath.FillRule = fillRule;
    }

    public void Dispose() => finish(_fillPath ?? strokePath);

    private void Write(Action<VectorPath> piece)
    {
        piece(strokePath);
        if (_isFilled && _fillPath is not null)
            piece(_fillPath);
    }
}
