namespace Engraver.Core.Geometry;

/// <summary>One smooth piece of a curve: a rational Bezier curve in space, parameter 0 to 1. Ellipse arcs and spline spans are such pieces exactly.</summary>
/// <remarks>Stored homogeneously, (x w, y w, z w, w) for each control point; all weights are positive, so the curve is inside the hull of its control points.
/// Immutable.</remarks>
public sealed class BezierSpan
{
    /// <summary>Doubles for each control point.</summary>
    public const int Stride = 4;

    /// <summary>A speed or a leg of the control polygon below this part of the span's size (largest distance of a control point from the first) is rounding and
    /// counts as zero.</summary>
    private const double ZeroSpeedShare = 1e-10;

    private readonly double[] _points;

    /// <param name="homogeneous">x w, y w, z w, w for each of the degree + 1 control points; taken over, not copied. Degree at least 1.</param>
    public BezierSpan(double[] homogeneous) => _points = homogeneous;

    public int Degree => (_points.Length / Stride) - 1;

    public ReadOnlySpan<double> Homogeneous => _points;

    public Point2D Start => Control(0);

    public Point2D End => Control(Degree);

    /// <summary>Direction of travel at the start (length 1): towards the first control point that differs from the first; zero for a point.</summary>
    public Vector2D StartTangent => FirstDirection(0, 1);

    public Vector2D EndTangent => -FirstDirection(Degree, -1);

    /// <summary>True when all control points coincide in plan.</summary>
    public bool IsPoint => StartTangent == default;

    /// <summary>A control point in plan.</summary>
    public Point2D Control(int index) => new(_points[index * Stride] / Weight(index), _points[(index * Stride) + 1] / Weight(index));

    public double Z(int index) => _points[(index * Stride) + 2] / Weight(index);

    public double Weight(int index) => _points[(index * Stride) + 3];

    public Point2D PointAt(double parameter) => Evaluate(parameter, out _);

    /// <summary>The point in plan and the derivative with respect to the parameter.</summary>
    public Point2D Evaluate(double parameter, out Vector2D derivative)
    {
        var place = EvaluateInSpace(parameter, out var slope);
        derivative = new Vector2D(slope.X, slope.Y);
        return new Point2D(place.X, place.Y);
    }

    /// <summary>Direction of travel (length 1). Where the speed is zero, the direction in which the span continues; at its end, the one in which it
    /// arrives.</summary>
    public Vector2D TangentAt(double parameter)
    {
        if (parameter <= 0.0) return StartTangent;
        if (parameter >= 1.0) return EndTangent;
        Evaluate(parameter, out var derivative);
        var (speed, still) = (derivative.Length, ZeroSpeedShare * Extent());
        return speed > still ? derivative * (1.0 / speed) : Part(parameter, 1.0).FirstDirection(0, 1, still);
    }

    /// <summary>The point in space and the derivative with respect to the parameter (de Casteljau).</summary>
    public Vector3D EvaluateInSpace(double parameter, out Vector3D derivative)
    {
        Span<double> work = stackalloc double[_points.Length];
        _points.CopyTo(work);
        for (var count = Degree; count > 1; count--) Interpolate(work, count, parameter);
        var (w0, w1) = (work[3], work[7]);
        var first = new Vector3D(work[0], work[1], work[2]);
        var last = new Vector3D(work[4], work[5], work[6]);
        var weight = w0 + (parameter * (w1 - w0));
        var place = (first + ((last - first) * parameter)) * (1.0 / weight);
        derivative = (last - first - (place * (w1 - w0))) * (Degree / weight);
        return place;
    }

    /// <summary>The part between two parameters as a separate span.</summary>
    public BezierSpan Part(double from, double to)
    {
        if (from == 0.0 && to == 1.0) return this;
        var points = (double[])_points.Clone();
        if (to < 1.0) KeepFirst(points, to);
        if (from > 0.0) KeepLast(points, to < 1.0 ? from / to : from);
        return new BezierSpan(points);
    }

    /// <summary>Both halves.</summary>
    public (BezierSpan First, BezierSpan Second) Halves()
    {
        var (first, second) = ((double[])_points.Clone(), (double[])_points.Clone());
        KeepFirst(first, 0.5);
        KeepLast(second, 0.5);
        return (new BezierSpan(first), new BezierSpan(second));
    }

    /// <summary>The same points in the opposite direction.</summary>
    public BezierSpan Reversed()
    {
        var points = new double[_points.Length];
        for (var i = 0; i <= Degree; i++) _points.AsSpan((Degree - i) * Stride, Stride).CopyTo(points.AsSpan(i * Stride));
        return new BezierSpan(points);
    }

    /// <summary>The span scaled about the origin.</summary>
    public BezierSpan Scaled(double factor)
    {
        var points = (double[])_points.Clone();
        for (var i = 0; i < points.Length; i++)
        {
            if (i % Stride != 3) points[i] *= factor;
        }

        return new BezierSpan(points);
    }

    /// <summary>The same points under a similarity of the plane; heights are scaled with it.</summary>
    public BezierSpan Mapped(Transform2D map)
    {
        var points = (double[])_points.Clone();
        for (var i = 0; i <= Degree; i++)
        {
            var (place, weight) = (map.Apply(Control(i)), Weight(i));
            (points[i * Stride], points[(i * Stride) + 1], points[(i * Stride) + 2]) = (place.X * weight, place.Y * weight, points[(i * Stride) + 2] * map.Scale);
        }

        return new BezierSpan(points);
    }

    private static void Interpolate(Span<double> work, int count, double parameter)
    {
        for (var i = 0; i < count * Stride; i++) work[i] += parameter * (work[i + Stride] - work[i]);
    }

    private void KeepFirst(double[] points, double parameter)
    {
        for (var level = 1; level <= Degree; level++)
        {
            for (var i = points.Length - 1; i >= level * Stride; i--) points[i] = points[i - Stride] + (parameter * (points[i] - points[i - Stride]));
        }
    }

    private void KeepLast(double[] points, double parameter)
    {
        for (var count = Degree; count >= 1; count--) Interpolate(points, count, parameter);
    }

    private Vector2D FirstDirection(int from, int step, double still = 0.0)
    {
        var place = Control(from);
        for (var i = from + step; i >= 0 && i <= Degree; i += step)
        {
            var chord = Control(i) - place;
            var length = chord.Length;
            if (length > Math.Max(still, 1e-14 * (Math.Abs(place.X) + Math.Abs(place.Y)))) return chord * (1.0 / length);
        }

        return default;
    }

    private double Extent()
    {
        var (place, extent) = (Control(0), 0.0);
        for (var i = 1; i <= Degree; i++) extent = Math.Max(extent, Control(i).DistanceTo(place));
        return extent;
    }
}
