using System.Diagnostics;

namespace Engraver.Core.Geometry;

/// <summary>A line, an arc or a whole circle with a direction: what contours and toolpaths are made of.</summary>
/// <remarks><see cref="Start"/> and <see cref="End"/> are stored, not computed, so that chained ends can be compared exactly; a circle starts and ends at its start angle.</remarks>
public readonly record struct Segment
{
    private readonly ArcSegment _arc;

    private Segment(SegmentKind kind, Point2D start, Point2D end, ArcSegment arc)
    {
        Kind = kind;
        Start = start;
        End = end;
        _arc = arc;
    }

    public SegmentKind Kind { get; }

    public Point2D Start { get; }

    public Point2D End { get; }

    /// <summary>The arc or circle itself. Only for <see cref="SegmentKind.Arc"/> and <see cref="SegmentKind.Circle"/>.</summary>
    public ArcSegment Arc => Kind == SegmentKind.Line ? throw new InvalidOperationException("A line has no arc.") : _arc;

    public LineSegment Line => new(Start, End);

    public double Length => Kind == SegmentKind.Line ? Line.Length : _arc.Length;

    public Bounds2D Bounds => Kind == SegmentKind.Line ? Line.Bounds : _arc.Bounds;

    /// <summary>Direction of travel at the start (length 1; zero for a line without length).</summary>
    public Vector2D StartTangent => Kind == SegmentKind.Line ? UnitChord() : _arc.TangentAt(0.0);

    /// <summary>Direction of travel at the end (length 1; zero for a line without length).</summary>
    public Vector2D EndTangent => Kind == SegmentKind.Line ? UnitChord() : _arc.TangentAt(1.0);

    public static Segment FromLine(Point2D start, Point2D end) => new(SegmentKind.Line, start, end, default);

    public static Segment FromLine(LineSegment line) => FromLine(line.Start, line.End);

    /// <summary>An arc or, with a sweep of exactly +-360 degrees, a circle.</summary>
    public static Segment FromArc(ArcSegment arc) => new(arc.IsFullTurn ? SegmentKind.Circle : SegmentKind.Arc, arc.StartPoint, arc.EndPoint, arc);

    /// <summary>An arc whose ends are known more exactly than its angles give them (both must lie on the circle to rounding).</summary>
    public static Segment FromArc(ArcSegment arc, Point2D start, Point2D end) => new(arc.IsFullTurn ? SegmentKind.Circle : SegmentKind.Arc, start, end, arc);

    public Segment Reversed() => Kind switch
    {
        SegmentKind.Line => new Segment(Kind, End, Start, default),
        SegmentKind.Arc or SegmentKind.Circle => new Segment(Kind, End, Start, _arc.Reversed()),
        _ => throw new UnreachableException(),
    };

    public Point2D PointAt(double fraction) => Kind == SegmentKind.Line ? Line.PointAt(fraction) : _arc.PointAt(fraction);

    public double DistanceTo(Point2D place) => Kind == SegmentKind.Line ? Line.DistanceTo(place) : _arc.DistanceTo(place);

    private Vector2D UnitChord()
    {
        var chord = End - Start;
        var length = chord.Length;
        return length == 0.0 ? default : chord * (1.0 / length);
    }
}
