namespace Engraver.Core.Geometry;

/// <summary>A box aligned with a direction: around a line its width is 0, whatever the direction of the line.</summary>
/// <param name="Centre">Its centre, millimetres.</param>
/// <param name="Along">Direction of its length, of length 1.</param>
/// <param name="HalfLength">From the centre along <paramref name="Along"/>, to either side.</param>
/// <param name="HalfWidth">From the centre across it, to either side.</param>
public readonly record struct OrientedBox(Point2D Centre, Vector2D Along, double HalfLength, double HalfWidth)
{
    /// <summary>Maximum error of the computed ends of a box, as a part of the coordinates.</summary>
    private const double Rounding = 2e-15;

    private static readonly Vector2D s_east = new(1.0, 0.0);

    /// <summary>The smallest box in the direction of the chord around the hull of some points.</summary>
    public static OrientedBox Around(Point2D start, Point2D end, params ReadOnlySpan<Point2D> others)
    {
        var extent = new OrientedExtent(start, DirectionOf(end - start));
        extent.Include(start);
        extent.Include(end);
        foreach (var place in others) extent.Include(place);
        return extent.Box();
    }

    /// <summary>A box around the control points.</summary>
    public static OrientedBox Around(BezierSpan span)
    {
        Span<Point2D> control = stackalloc Point2D[span.Degree + 1];
        for (var i = 0; i < control.Length; i++) control[i] = span.Control(i);
        return Around(control[0], control[^1], control[1..^1]);
    }

    /// <summary>A box around a line, an arc of any sweep, or a curve of one span.</summary>
    public static OrientedBox Around(in Segment path)
    {
        if (path.Kind == SegmentKind.Line) return Around(path.Start, path.End);
        if (path.IsFreeCurve) return Around(path.Curve.Spans[0]);
        var arc = path.Arc;
        if (Math.Abs(arc.Sweep.Degrees) > 180.0) return new OrientedBox(arc.Centre, s_east, arc.Radius, arc.Radius).Grown(0.0);
        var (start, end, top) = (arc.StartPoint, arc.EndPoint, arc.PointAt(0.5));
        var chord = new Point2D(start.X + ((end.X - start.X) / 2.0), start.Y + ((end.Y - start.Y) / 2.0));
        return Around(start, end, start + (top - chord), end + (top - chord)); // the chord and the line through the top of the arc
    }

    /// <summary>The box enlarged on every side by this length and by the possible rounding.</summary>
    public OrientedBox Grown(double by)
    {
        var margin = by + (Rounding * (Math.Abs(Centre.X) + Math.Abs(Centre.Y) + HalfLength + HalfWidth));
        return this with { HalfLength = HalfLength + margin, HalfWidth = HalfWidth + margin };
    }

    /// <summary>Distance of a point from the box; 0 inside.</summary>
    public double DistanceTo(Point2D place)
    {
        var spoke = place - Centre;
        var along = Math.Abs(spoke.Dot(Along)) - HalfLength;
        var across = Math.Abs(Along.Cross(spoke)) - HalfWidth;
        if (along <= 0.0) return Math.Max(0.0, across);
        return across <= 0.0 ? along : Math.Sqrt((along * along) + (across * across));
    }

    /// <summary>Distance of the farthest corner.</summary>
    public double FarthestFrom(Point2D place)
    {
        var spoke = place - Centre;
        var along = Math.Abs(spoke.Dot(Along)) + HalfLength;
        var across = Math.Abs(Along.Cross(spoke)) + HalfWidth;
        return Math.Sqrt((along * along) + (across * across));
    }

    /// <summary>True when the boxes have a point in common: no side of either separates them.</summary>
    public bool Overlaps(in OrientedBox other)
    {
        var way = other.Centre - Centre;
        var (cos, sin) = (Math.Abs(Along.Dot(other.Along)), Math.Abs(Along.Cross(other.Along)));
        return Math.Abs(way.Dot(Along)) <= HalfLength + (other.HalfLength * cos) + (other.HalfWidth * sin)
            && Math.Abs(way.Cross(Along)) <= HalfWidth + (other.HalfLength * sin) + (other.HalfWidth * cos)
            && Math.Abs(way.Dot(other.Along)) <= other.HalfLength + (HalfLength * cos) + (HalfWidth * sin)
            && Math.Abs(way.Cross(other.Along)) <= other.HalfWidth + (HalfLength * sin) + (HalfWidth * cos);
    }

    internal static Vector2D DirectionOf(Vector2D way)
    {
        var length = way.Length;
        return length > 0.0 ? way * (1.0 / length) : s_east;
    }
}

/// <summary>Extent of objects along a direction and across it, relative to a point near them.</summary>
internal struct OrientedExtent(Point2D origin, Vector2D along)
{
    private double _minAlong = double.PositiveInfinity;
    private double _maxAlong = double.NegativeInfinity;
    private double _minAcross = double.PositiveInfinity;
    private double _maxAcross = double.NegativeInfinity;

    public readonly double Area(double margin) => (_maxAlong - _minAlong + margin) * (_maxAcross - _minAcross + margin);

    public void Include(Point2D place) => Include(place - origin, 0.0, 0.0);

    public void Include(in OrientedBox box)
    {
        var (cos, sin) = (Math.Abs(along.Dot(box.Along)), Math.Abs(along.Cross(box.Along)));
        Include(box.Centre - origin, (box.HalfLength * cos) + (box.HalfWidth * sin), (box.HalfLength * sin) + (box.HalfWidth * cos));
    }

    public readonly OrientedBox Box()
    {
        var across = new Vector2D(-along.Y, along.X);
        var centre = origin + (along * ((_minAlong + _maxAlong) / 2.0)) + (across * ((_minAcross + _maxAcross) / 2.0));
        return new OrientedBox(centre, along, (_maxAlong - _minAlong) / 2.0, (_maxAcross - _minAcross) / 2.0).Grown(0.0);
    }

    private void Include(Vector2D spoke, double halfAlong, double halfAcross)
    {
        var (ahead, left) = (spoke.Dot(along), along.Cross(spoke));
        (_minAlong, _maxAlong) = (Math.Min(_minAlong, ahead - halfAlong), Math.Max(_maxAlong, ahead + halfAlong));
        (_minAcross, _maxAcross) = (Math.Min(_minAcross, left - halfAcross), Math.Max(_maxAcross, left + halfAcross));
    }
}
