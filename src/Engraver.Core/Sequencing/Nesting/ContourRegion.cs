using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Nesting;

/// <summary>The region inside a closed contour, with exact arcs: its area, whether a point is inside (even-odd rule), and how often the contour runs around
/// it.</summary>
public sealed class ContourRegion
{
    private readonly Segment[] _segments;
    private readonly Lazy<BoxTree> _boxes;
    private readonly List<int> _crossed = [];

    /// <param name="segments">Segments in order and direction of travel, end joined to start (a gap within the join tolerance is ignored).</param>
    public ContourRegion(Segment[] segments)
    {
        _segments = segments;
        _boxes = new Lazy<BoxTree>(() => BoxTree.Build([.. segments.Select(BoxOf)]));
        foreach (var segment in segments) Bounds = Bounds.Union(BoxOf(segment));
    }

    public Bounds2D Bounds { get; } = Bounds2D.Empty;

    /// <summary>Counter-clockwise positive, mm2: the polygon of the ends plus the cap of every arc (Green's theorem).</summary>
    public double SignedArea => _segments.Sum(segment => Cross(segment) + Cap(segment)) / 2.0;

    /// <summary>True when the contour runs an odd number of times around a point. For a point on the contour either result is possible.</summary>
    public bool Contains(Point2D place) => (Winding(place) & 1) != 0;

    /// <summary>Times that the contour runs around a point, counter-clockwise positive: its crossings of a ray to the right. For a point on the contour either
    /// side's result is possible.</summary>
    public int Winding(Point2D place)
    {
        if (!Bounds.Contains(place)) return 0;
        _crossed.Clear();
        _boxes.Value.Overlapping(new Bounds2D(place.X, place.Y, double.PositiveInfinity, place.Y), _crossed);
        var winding = 0;
        foreach (var segment in _crossed) winding += _segments[segment].Kind == SegmentKind.Line ? LineCrossing(_segments[segment].Line, IsRightOf(_segments[segment].Line, place), place) : ArcCrossings(_segments[segment], place);
        return winding;
    }

    /// <summary>Includes the stored ends: those computed from the angles of an arc can differ from them by rounding, and a ray between the two would miss the
    /// arc.</summary>
    private static Bounds2D BoxOf(Segment segment) => segment.Bounds.Including(segment.Start).Including(segment.End);

    /// <summary>Cross product of the ends relative to the first start, so that a drawing far from the origin loses no digits.</summary>
    private double Cross(Segment segment)
    {
        var origin = _segments[0].Start;
        return (segment.Start - origin).Cross(segment.End - origin);
    }

    private static double Cap(Segment segment)
    {
        if (segment.Kind == SegmentKind.Line) return 0.0;
        var arc = segment.Arc;
        return arc.Radius * arc.Radius * (arc.Sweep.Radians - arc.Sweep.Sin());
    }

    /// <summary>1 for a line that crosses the ray upwards, -1 downwards; half-open in y, so that a vertex on the ray counts once.</summary>
    private static int LineCrossing(LineSegment line, bool isRightOfLine, Point2D place)
    {
        var isUpwards = line.End.Y > place.Y;
        if (line.Start.Y > place.Y == isUpwards || isRightOfLine == isUpwards) return 0;
        return isUpwards ? 1 : -1;
    }

    /// <summary>The chord's crossing, plus a turn when the point is between chord and arc. One comparison decides both: a point exactly on the chord is on the
    /// same side for both.</summary>
    private static int ArcCrossings(Segment segment, Point2D place)
    {
        var arc = segment.Arc;
        var isCounterClockwise = arc.Sweep.Degrees > 0.0;
        var turn = isCounterClockwise ? 1 : -1;
        var isInCircle = (place - arc.Centre).LengthSquared < arc.Radius * arc.Radius;
        if (segment.Kind == SegmentKind.Circle) return isInCircle ? turn : 0;
        var isRightOfChord = IsRightOf(segment.Line, place);
        var chord = LineCrossing(segment.Line, isRightOfChord, place);
        return isInCircle && isRightOfChord == isCounterClockwise ? chord + turn : chord;
    }

    /// <summary>A point exactly on a line is on the left of its upward (or rightward) direction, as if it were slightly to the left and even less above: lines
    /// of both directions and half-open ends agree.</summary>
    private static bool IsRightOf(LineSegment line, Point2D place)
    {
        var isUpwards = line.End.Y > line.Start.Y || (line.End.Y == line.Start.Y && line.End.X > line.Start.X);
        var (low, high) = isUpwards ? (line.Start, line.End) : (line.End, line.Start);
        return (high - low).Cross(place - low) < 0.0 == isUpwards;
    }
}
