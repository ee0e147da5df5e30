using Avalonia;
using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Rasteriser.Paths;

/// <summary>Figures of lines and cubic curves in local coordinates, y down. Quadratic curves and elliptical arcs become cubics when they are added.</summary>
internal sealed class VectorPath
{
    private PathVerb[] _verbs = new PathVerb[8];
    private Point[] _points = new Point[16];
    private int _verbCount;
    private int _pointCount;
    private Point _figureStart;

    public VectorPath(FillRule fillRule = FillRule.EvenOdd) => FillRule = fillRule;

    public FillRule FillRule { get; set; }

    public ReadOnlySpan<PathVerb> Verbs => _verbs.AsSpan(0, _verbCount);

    public ReadOnlySpan<Point> Points => _points.AsSpan(0, _pointCount);

    public bool IsEmpty => _verbCount == 0;

    /// <summary>End of what was added last; after a close, the start of the closed figure.</summary>
    public Point Current { get; private set; }

    public void Clear(FillRule fillRule)
    {
        _verbCount = _pointCount = 0;
        FillRule = fillRule;
    }

    public void MoveTo(Point point)
    {
        Add(PathVerb.Move);
        Add(point);
        _figureStart = point;
    }

    public void LineTo(Point point)
    {
        Add(PathVerb.Line);
        Add(point);
    }

    public void CubicTo(Point control1, Point control2, Point end)
    {
        Add(PathVerb.Cubic);
        Add(control1);
        Add(control2);
        Add(end);
    }

    public void QuadraticTo(Point control, Point end)
    {
        var start = Current;
        CubicTo(start + (control - start) * (2.0 / 3), end + (control - end) * (2.0 / 3), end);
    }

    public void Close()
    {
        Add(PathVerb.Close);
        Current = _figureStart;
    }

    /// <summary>Adds all figures of <paramref name="other"/>, transformed. The fill rule stays.</summary>
    public void Append(VectorPath other, in Matrix transform)
    {
        var points = other.Points;
        var next = 0;
        foreach (var verb in other.Verbs)
        {
            switch (verb)
            {
                case PathVerb.Move:
                    MoveTo(points[next++].Transform(transform));
                    break;
                case PathVerb.Line:
                    LineTo(points[next++].Transform(transform));
                    break;
                case PathVerb.Cubic:
                    CubicTo(points[next].Transform(transform), points[next + 1].Transform(transform), points[next + 2].Transform(transform));
                    next += 3;
                    break;
                default:
                    Close();
                    break;
            }
        }
    }

    public VectorPath Transformed(in Matrix transform)
    {
        var copy = new VectorPath(FillRule);
        copy.Append(this, transform);
        return copy;
    }

    /// <summary>Box around all points, control points included: never smaller than the curve. Null for a path without points.</summary>
    public Rect? ControlBounds(in Matrix transform)
    {
        if (_pointCount == 0)
            return null;
        double left = double.MaxValue, top = double.MaxValue, right = double.MinValue, bottom = double.MinValue;
        foreach (var point in Points)
        {
            var x = point.X * transform.M11 + point.Y * transform.M21 + transform.M31;
            var y = point.X * transform.M12 + point.Y * transform.M22 + transform.M32;
            left = Math.Min(left, x);
            right = Math.Max(right, x);
            top = Math.Min(top, y);
            bottom = Math.Max(bottom, y);
        }
        return new Rect(new Point(left, top), new Point(right, bottom));
    }

    private void Add(PathVerb verb)
    {
        if (_verbCount == _verbs.Length)
            Array.Resize(ref _verbs, _verbCount * 2);
        _verbs[_verbCount++] = verb;
    }

    private void Add(Point point)
    {
        if (_pointCount == _points.Length)
            Array.Resize(ref _points, _pointCount * 2);
        _points[_pointCount++] = point;
        Current = point;
    }
}

/// <summary>What the next points of a path mean: one point, one point, three points, none.</summary>
internal enum PathVerb : byte
{
    Move,
    Line,
    Cubic,
    Close,
}
