using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Scenes;

/// <summary>Start angle and signed sweep of an arc, radians, counter-clockwise positive.</summary>
internal readonly record struct ArcSpan(double Start, double Sweep)
{
    private const double QuarterTurn = Math.PI / 2.0;

    public static ArcSpan From(ArcSegment arc) => new(arc.Start.Radians, arc.Sweep.Radians);

    public Point2D PointAt(Point2D centre, double radius, double fraction)
    {
        var (sine, cosine) = Math.SinCos(Start + (Sweep * fraction));
        return new Point2D(centre.X + (radius * cosine), centre.Y + (radius * sine));
    }

    /// <summary>Tight box: both ends and every quadrant point between them.</summary>
    public Bounds2D BoundsOf(Point2D centre, double radius)
    {
        var (low, high) = Sweep >= 0.0 ? (Start, Start + Sweep) : (Start + Sweep, Start);
        var box = Bounds2D.FromCorners(PointAt(centre, radius, 0.0), PointAt(centre, radius, 1.0));
        for (var quarter = Math.Ceiling(low / QuarterTurn); quarter <= high / QuarterTurn; quarter++) box = box.Including(Quadrant(centre, radius, (int)((quarter % 4.0) + 4.0) % 4));
        return box;
    }

    private static Point2D Quadrant(Point2D centre, double radius, int quarter) => quarter switch
    {
        0 => new Point2D(centre.X + radius, centre.Y),
        1 => new Point2D(centre.X, centre.Y + radius),
        2 => new Point2D(centre.X - radius, centre.Y),
        _ => new Point2D(centre.X, centre.Y - radius),
    };
}
