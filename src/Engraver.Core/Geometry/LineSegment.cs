namespace Engraver.Core.Geometry;

/// <summary>A straight line between two points, with a direction.</summary>
public readonly record struct LineSegment(Point2D Start, Point2D End)
{
    public double Length => Start.DistanceTo(End);

    public Bounds2D Bounds => Bounds2D.FromCorners(Start, End);

    public LineSegment Reversed() => new(End, Start);

    public Point2D PointAt(double fraction) => Start + ((End - Start) * fraction);

    /// <summary>Shortest distance from a point to the line segment, its ends included.</summary>
    public double DistanceTo(Point2D place)
    {
        var along = End - Start;
        var squared = along.LengthSquared;
        if (squared == 0.0) return Start.DistanceTo(place);
        var fraction = Math.Clamp((place - Start).Dot(along) / squared, 0.0, 1.0);
        return PointAt(fraction).DistanceTo(place);
    }
}
