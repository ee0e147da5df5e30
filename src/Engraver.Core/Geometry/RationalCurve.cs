namespace Engraver.Core.Geometry;

/// <summary>An ellipse, an elliptical arc or a spline, exact: rational Bezier spans joined end to start, with a direction. What the side column of kinds 4 and 5 holds.</summary>
/// <remarks>Compared by reference. Lengths and box are found when first asked for; a curve never changes otherwise.</remarks>
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

    /// <summary>As seen from above, to 1e-9 relative or better.</summary>
    public double PlanLength => double.IsNaN(_planLength) ? _planLength = Length(inPlan: true) : _planLength;

    /// <summary>Along the curve in space.</summary>
    public double SpaceLength => double.IsNaN(_spaceLength) ? _spaceLength = IsLevel() ? PlanLength : Length(inPlan: false) : _spaceLength;

    /// <summary>Tight box in plan.</summary>
    public Bounds2D Bounds => _bounds ??= _spans.Aggregate(Bounds2D.Empty, CurveBounds.Including);

    /// <summary>The same points in the opposite direction.</summary>
    public RationalCurve Reversed()
    {
        var spans = new BezierSpan[_spans.Length];
        for (var i = 0; i < spans.Length; i++) spans[i] = _spans[^(i + 1)].Reversed();
        return new RationalCurve(Kind, spans) { _planLength = _planLength, _spaceLength = _spaceLength, _bounds = _bounds };
    }

    /// <summary>Stretched from the origin: drawing units to millimetres.</summary>
    public RationalCurve Scaled(double factor) => factor == 1.0 ? this : With([.. _spans.Select(span => span.Scaled(factor))]);

    /// <summary>The same curve seen through a similarity of the plan; heights scale with it.</summary>
    public RationalCurve Mapped(Transform2D map) => With([.. _spans.Select(span => span.Mapped(map))]);

    /// <summary>The same curve moved: its spans one for one. What was closed stays exactly closed.</summary>
    public RationalCurve With(BezierSpan[] spans)
    {
        if (IsClosed) CloseExactly(spans);
        return new RationalCurve(Kind, spans);
    }

    /// <summary>The place at a fraction of the parameter (not of the length); 0 and 1 are exactly the ends.</summary>
    public Point2D PointAt(double fraction)
    {
        if (fraction <= 0.0) return Start;
        if (fraction >= 1.0) return End;
        var place = fraction * _spans.Length;
        var span = Math.Min((int)place, _spans.Length - 1);
        return _spans[span].PointAt(place - span);
    }

    /// <summary>Direction of travel (length 1) at a fraction of the parameter; where the curve stands still, that in which it goes on.</summary>
    public Vector2D TangentAt(double fraction)
    {
        if (fraction <= 0.0) return StartTangent;
        if (fraction >= 1.0) return EndTangent;
        var place = fraction * _spans.Length;
        var span = Math.Min((int)place, _spans.Length - 1);
        return _spans[span].TangentAt(place - span);
    }

    /// <summary>The curve in pieces that are nearly straight and nearly even in speed.</summary>
    public IReadOnlyList<RationalCurve> Pieces() => _pieces ??= CurvePieces.Split(this);

    /// <summary>Shortest distance from a place to the curve in plan, its ends included.</summary>
    public double DistanceTo(Point2D place)
    {
        var nearest = double.PositiveInfinity;
        foreach (var span in _spans) nearest = SpanDistance.Measure(span, place, nearest);
        return nearest;
    }

    /// <summary>Puts the last end exactly on the first start: quotients of different weights round differently.</summary>
    internal static void CloseExactly(BezierSpan[] spans)
    {
        if (spans[0].Start == spans[^1].End) return;
        var points = spans[^1].Homogeneous.ToArray();
        var factor = 1.0 / points[^1];
        for (var i = 0; i < points.Length; i++) points[i] *= factor; // a common factor changes nothing
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

    private bool IsLevel()
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
