namespace Engraver.Core.Geometry;

/// <summary>A line, an arc, a whole circle, an ellipse or a spline with a direction: the elements of contours (in toolpaths: lines, arcs and circles
/// only).</summary>
/// <remarks><see cref="Start"/> and <see cref="End"/> are stored, not computed, so that chained ends can be compared exactly; a circle starts and ends at its
/// start angle.</remarks>
public readonly record struct Segment
{
    private readonly ArcSegment _arc;
    private readonly RationalCurve? _curve;

    private Segment(SegmentKind kind, Point2D start, Point2D end, ArcSegment arc, RationalCurve? curve = null)
    {
        Kind = kind;
        Start = start;
        End = end;
        _arc = arc;
        _curve = curve;
    }

    public SegmentKind Kind { get; }

    public Point2D Start { get; }

    public Point2D End { get; }

    /// <summary>True for an ellipse or spline, which has a <see cref="Curve"/>; the toolpath has arcs and lines instead.</summary>
    public bool IsFreeCurve => _curve is not null;

    /// <summary>True for a circle, or an ellipse or spline that ends where it starts: a closed contour of one segment.</summary>
    public bool IsClosed => Kind == SegmentKind.Circle || (_curve is not null && Start == End);

    /// <summary>The arc or circle itself. Only for <see cref="SegmentKind.Arc"/> and <see cref="SegmentKind.Circle"/>.</summary>
    public ArcSegment Arc => Kind is SegmentKind.Arc or SegmentKind.Circle ? _arc : throw new InvalidOperationException($"A {Kind} has no arc.");

    /// <summary>The exact curve, in the direction of travel. Only where <see cref="IsFreeCurve"/> holds.</summary>
    public RationalCurve Curve => _curve ?? throw new InvalidOperationException($"A {Kind} has no curve of its own.");

    public LineSegment Line => new(Start, End);

    public double Length => Kind == SegmentKind.Line ? Line.Length : _curve?.PlanLength ?? _arc.Length;

    public Bounds2D Bounds => Kind == SegmentKind.Line ? Line.Bounds : _curve?.Bounds ?? _arc.Bounds;

    /// <summary>Direction of travel at the start (length 1; zero for a line without length).</summary>
    public Vector2D StartTangent => TangentAt(0.0);

    /// <summary>Direction of travel at the end (length 1; zero for a line without length).</summary>
    public Vector2D EndTangent => TangentAt(1.0);

    public static Segment FromLine(Point2D start, Point2D end) => new(SegmentKind.Line, start, end, default);

    public static Segment FromLine(LineSegment line) => FromLine(line.Start, line.End);

    /// <summary>An arc or, with a sweep of exactly +-360 degrees, a circle.</summary>
    public static Segment FromArc(ArcSegment arc) => new(arc.IsFullTurn ? SegmentKind.Circle : SegmentKind.Arc, arc.StartPoint, arc.EndPoint, arc);

    /// <summary>An arc whose ends are known more exactly than its angles give them (both must be on the circle within rounding).</summary>
    public static Segment FromArc(ArcSegment arc, Point2D start, Point2D end) => new(arc.IsFullTurn ? SegmentKind.Circle : SegmentKind.Arc, start, end, arc);

    /// <summary>An ellipse or spline as one segment.</summary>
    public static Segment FromCurve(RationalCurve curve) => new(curve.Kind, curve.Start, curve.End, default, curve);

    public Segment Reversed()
    {
        if (Kind == SegmentKind.Line) return new Segment(Kind, End, Start, default);
        return _curve is null ? new Segment(Kind, End, Start, _arc.Reversed()) : FromCurve(_curve.Reversed());
    }

    /// <summary>The segment under a similarity of the plane.</summary>
    public Segment Mapped(Transform2D map) => _curve is not null ? FromCurve(_curve.Mapped(map)) : new Segment(Kind, map.Apply(Start), map.Apply(End), Kind == SegmentKind.Line ? default : map.Apply(_arc));

    /// <summary>The point at a fraction of a line's length, an arc's sweep, a curve's parameter.</summary>
    public Point2D PointAt(double fraction) => Kind == SegmentKind.Line ? Line.PointAt(fraction) : _curve?.PointAt(fraction) ?? _arc.PointAt(fraction);

    /// <summary>Direction of travel (length 1; zero for a line without length) at a fraction as in <see cref="PointAt"/>.</summary>
    public Vector2D TangentAt(double fraction) => Kind == SegmentKind.Line ? UnitChord() : _curve?.TangentAt(fraction) ?? _arc.TangentAt(fraction);

    public double DistanceTo(Point2D place) => Kind == SegmentKind.Line ? Line.DistanceTo(place) : _curve?.DistanceTo(place) ?? _arc.DistanceTo(place);

    private Vector2D UnitChord()
    {
        var chord = End - Start;
        var length = chord.Length;
        return length == 0.0 ? default : chord * (1.0 / length);
    }
}
