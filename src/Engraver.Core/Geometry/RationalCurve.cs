namespace Engraver.Core.Geometry;

/// <summary>An ellipse, an elliptical arc or a spline, exact: rational Bezier spans joined end to start, with a direction. Rows of kinds 4 and 5 of the entity
/// table have one in a side column.</summary>
/// <remarks>Compared by reference. Immutable; lengths and box are computed on first use.</remarks>
public sealed class RationalCurve
{
    private readonly BezierSpan[] _spans;
    private double _planLength = double.NaN;
    private double _spaceLength = double.NaN;
    private Bounds2D? _bounds;
    private RationalCurve[]? _pieces;

    /// <param name="kind">Ellipse or spline.</param>
    /// <param name="spans">At least one, in the order of travel; taken over, not copied.</param>
    public RationalCurve(SegmentKind kind, BezierSpan[] spans)
    {
        Kind = kind;
        _spans = spans;
    }

    public SegmentKind Kind { get; }

    public ReadOnlySpan<BezierSpan> Spans => _spans;

    public Point2D Start => _spans[0].Start;

    public Point2D End => _spans[^1].End;

    public double StartZ => _spans[0].Z(0);

    public double EndZ => _spans[^1].Z(_spans[^1].Degree);

    /// <summary>True when the curve ends exactly where it starts, in plan.</summary>
    public bool IsClosed => Start == End;

    public Vector2D StartTangent => _spans[0].StartTangent;

    public Vector2D EndTangent => _spans[^1].EndTangent;

    /// <summary>Length of the projection to the XY plane, relative error at most 1e-9.</summary>
    public double PlanLength => double.IsNaN(_planLength) ? _planLength = Length(inPlan: true) : _planLength;

    /// <summary>Length of the curve in space.</summary>
    public double SpaceLength => double.IsNaN(_spaceLength) ? _spaceLength = IsLevel ? PlanLength : Length(inPlan: false) : _spaceLength;

    /// <summary>Smallest box in plan.</summary>
    public Bounds2D Bounds => _bounds ??= _spans.Aggregate(Bounds2D.Empty, CurveBounds.Including);

    /// <summary>The same points in the opposite direction.</summary>
    public RationalCurve Reversed()
    {
        var spans = new BezierSpan[_spans.Length];
        for (var i = 0; i < spans.Length; i++) spans[i] = _spans[^(i + 1)].Reversed();
        return new RationalCurve(Kind, spans) { _planLength = _planLength, _spaceLength = _spaceLength, _bounds = _bounds };
    }

    /// <summary>The curve scaled about the origin: drawing units to millimetres.</summary>
    public RationalCurve Scaled(double factor) => factor == 1.0 ? this : With([.. _spans.Select(span => span.Scaled(factor))]);

    /// <summary>The same curve under a similarity of the plane; heights are scaled with it.</summary>
    public RationalCurve Mapped(Transform2D map) => With([.. _spans.Select(span => span.Mapped(map))]);

    /// <summary>The same kind of curve with other spans, one for one. A closed curve remains exactly closed.</summary>
    public RationalCurve With(BezierSpan[] spans)
    {
        if (IsClosed) CloseExactly(spans);
        return new RationalCurve(Kind, spans);
    }

    /// <summary>The point at a fraction of the parameter (not of the length); 0 and 1 are exactly the ends.</summary>
    public Point2D PointAt(double fraction)
    {
        if (fraction <= 0.0) return Start;
        if (fraction >= 1.0) return End;
        var place = fraction * _spans.Length;
        var span = Math.Min((int)place, _spans.Length - 1);
        return _spans[span].PointAt(place - span);
    }

    /// <summary>Direction of travel (length 1) at a fraction of the parameter; where the speed is zero, the direction in which the curve continues.</summary>
    public Vector2D TangentAt(double fraction)
    {
        if (fraction <= 0.0) return StartTangent;
        if (fraction >= 1.0) return EndTangent;
        var place = fraction * _spans.Length;
        var span = Math.Min((int)place, _spans.Length - 1);
        return _spans[span].TangentAt(place - span);
    }

    /// <summary>The curve in pieces that are nearly straight and of nearly constant speed.</summary>
    public IReadOnlyList<RationalCurve> Pieces() => _pieces ??= CurvePieces.Split(this);

    /// <summary>Shortest distance from a point to the curve in plan, its ends included.</summary>
    public double DistanceTo(Point2D place)
    {
        var nearest = double.PositiveInfinity;
        foreach (var span in _spans) nearest = SpanDistance.Measure(span, place, nearest);
        return nearest;
    }

    /// <summary>Sets the last end to exactly the first start: quotients by different weights round differently.</summary>
    internal static void CloseExactly(BezierSpan[] spans)
    {
        if (spans[0].Start == spans[^1].End) return;
        var points = spans[^1].Homogeneous.ToArray();
        var factor = 1.0 / points[^1];
        for (var i = 0; i < points.Length; i++) points[i] *= factor; // a common factor of all homogeneous coordinates does not change the curve
        var start = spans.Length == 1 ? new BezierSpan(points).Start : spans[0].Start;
        (points[^4], points[^3], points[^1]) = (start.X, start.Y, 1.0);
        spans[^1] = new BezierSpan(points);
    }

    private double Length(bool inPlan)
    {
        var sum = 0.0;
        foreach (var span in _spans) sum += ArcLength.Measure(span, inPlan);
        return sum;
    }

    /// <summary>The whole curve is at one height: that of its start.</summary>
    public bool IsLevel
    {
        get
        {
            var z = StartZ;
            foreach (var span in _spans)
            {
                for (var i = 0; i <= span.Degree; i++)
                {
                    if (span.Z(i) != z) return false;
                }
            }

            return true;
        }
    }
}
