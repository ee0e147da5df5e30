using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Nesting;

/// <summary>The region inside a closed contour, with exact arcs: its area, whether a point is inside (even-odd rule), and how often the contour runs around it.</summary>
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
        foreach (var segment in _crossed) winding += _segments[segment].Kind == SegmentKind.Line ? LineCrossing(_segments[segment].Line, place) : ArcCrossings(_segments[segment], place);
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
    private static int LineCrossing(LineSegment line, Point2D place)
    {
        if (line.Start.Y > place.Y == line.End.Y > place.Y) return 0;
        var fraction = (place.Y - line.Start.Y) / (line.End.Y - line.Start.Y);
        if (!(line.Start.X + (fraction * (line.End.X - line.Start.X)) > place.X)) return 0;
        return line.End.Y > line.Start.Y ? 1 : -1;
    }

    /// <summary>The chord's crossing, plus a turn when the point is between chord and arc.</summary>
    private static int ArcCrossings(Segment segment, Point2D place)
    {
        var arc = segment.Arc;
        var isCounterClockwise = arc.Sweep.Degrees > 0.0;
        var turn = isCounterClockwise ? 1 : -1;
        var isInCircle = (place - arc.Centre).LengthSquared < arc.Radius * arc.Radius;
        if (segment.Kind == SegmentKind.Circle) return isInCircle ? turn : 0;
        var chord = LineCrossing(segment.Line, place);
        var isRightOfChord = (segment.End - segment.Start).Cross(place - segment.Start) < 0.0;
        return isInCircle && isRightOfChord == isCounterClockwise ? chord + turn : chord;
    }
}
