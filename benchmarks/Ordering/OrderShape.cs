using Engraver.Core.Geometry;

namespace Engraver.Benchmarks.Ordering;

/// <summary>One stroke of an instance.</summary>
/// <param name="Points">Corners, mm; of a circle its centre.</param>
/// <param name="IsClosed">The last corner is joined with the first.</param>
/// <param name="Radius">Radius of a circle, mm; 0 for a polyline.</param>
/// <param name="Around">Index of the closed stroke directly around it, -1 for none.</param>
internal sealed record OrderShape(Point2D[] Points, bool IsClosed, double Radius, int Around)
{
    public bool IsCircle => Radius > 0.0;

    public static OrderShape Circle(Point2D centre, double radius, int around) => new([centre], true, radius, around);

    /// <summary>A polygon with corners on a circle, beginning at an angle.</summary>
    public static OrderShape Polygon(Point2D centre, double radius, int corners, double angle, int around) =>
        new([.. Enumerable.Range(0, corners).Select(i => OnCircle(centre, radius, angle + (Math.Tau * i / corners)))], true, 0.0, around);

    public static OrderShape Box(double x, double y, double width, double height, int around) =>
        new([new(x, y), new(x + width, y), new(x + width, y + height), new(x, y + height)], true, 0.0, around);

    public static OrderShape Path(Point2D[] points) => new(points, false, 0.0, -1);

    public static Point2D OnCircle(Point2D centre, double radius, double angle) => centre + new Vector2D(radius * Math.Cos(angle), radius * Math.Sin(angle));

    /// <summary>Number of entities of the drawing that draw it.</summary>
    public int Entities => IsCircle ? 1 : IsClosed ? Points.Length : Points.Length - 1;

    /// <summary>Its lines, or its circle.</summary>
    public IEnumerable<Segment> Segments()
    {
        if (IsCircle) return [Segment.FromArc(new ArcSegment(Points[0], Radius, default, Angle.FromRadians(Math.Tau)))];
        return Enumerable.Range(0, Entities).Select(i => Segment.FromLine(Points[i], Points[(i + 1) % Points.Length]));
    }
}
