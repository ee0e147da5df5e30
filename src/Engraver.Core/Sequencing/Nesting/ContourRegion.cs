using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Nesting;

/// <summary>The region inside a closed contour, with exact arcs: its area, and whether a point is inside (even-odd rule).</summary>
public sealed class ContourRegion
{
    private readonly Segment[] _segments;
    private readonly Lazy<BoxTree> _boxes;
    private readonly List<int> _crossed = [];

    /// <param name="segments">Segments in order and direction of travel, end joined to start (a gap within the join tolerance is ignored).</param>
    public ContourRegion(Segment[] segments)
    {
        _segments = segments;
        _boxes = new Lazy<BoxTree>(() => BoxTree.Build([.. segments.Select(segment => segment.Bounds)]));
        foreach (var segment in segments) Bounds = Bounds.Union(segment.Bounds);
    }

    public Bounds2D Bounds { get; } = Bounds2D.Empty;

    /// <summary>Counter-clockwise positive, mm2: the polygon of the ends plus the cap of every arc (Green's theorem).</summary>
    public double SignedArea => _segments.Sum(segment => Cross(segment) + Cap(segment)) / 2.0;

    /// <summary>True when a ray from <paramref name="place"/> to the right crosses the contour an odd number of times. For a point on the contour either result
    /// is possible.</summary>
    public bool Contains(Point2D place)
    {
        if (!Bounds.Contains(place)) return false;
        _crossed.Clear();
        _boxes.Value.Overlapping(new Bounds2D(place.X, place.Y, double.PositiveInfinity, place.Y), _crossed);
        var crossings = 0;
        foreach (var segment in _crossed) crossings += _segments[segment].Kind == SegmentKind.Line ? LineCrossings(_segments[segment].Line, place) : ArcCrossings(_segments[segment], place);
        return (crossings & 1) == 1;
    }

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

    /// <summary>Counts crossings of a line; half-open in y, so that a vertex on the ray counts once.</summary>
    private static int LineCrossings(LineSegment line, Point2D place)
    {
        if (line.Start.Y > place.Y == line.End.Y > place.Y) return 0;
        var fraction = (place.Y - line.Start.Y) / (line.End.Y - line.Start.Y);
        return line.Start.X + (fraction * (line.End.X - line.Start.X)) > place.X ? 1 : 0;
    }

    /// <summary>The chord's crossings, plus one when the point is between chord and arc.</summary>
    private static int ArcCrossings(Segment segment, Point2D place)
    {
        var arc = segment.Arc;
        var isInCircle = (place - arc.Centre).LengthSquared < arc.Radius * arc.Radius;
        if (segment.Kind == SegmentKind.Circle) return isInCircle ? 1 : 0;
        var chord = LineCrossings(segment.Line, place);
        var isRightOfChord = (segment.End - segment.Start).Cross(place - segment.Start) < 0.0;
        return isInCircle && isRightOfChord == arc.Sweep.Degrees > 0.0 ? chord + 1 : chord;
    }
}
