namespace Engraver.Core.Geometry.Constructions;

/// <summary>The cut at every corner of a closed outline: a chamfer or a rounding.</summary>
/// <param name="Before">Length that is removed from the side before the corner.</param>
/// <param name="After">Length that is removed from the side after the corner.</param>
/// <param name="Radius">Radius of the arc; 0 for a chamfer.</param>
public readonly record struct CornerCut(double Before, double After, double Radius)
{
    public static CornerCut None => default;

    public static CornerCut Chamfer(double before, double after) => new(before, after, 0.0);

    /// <summary>Rounds right-angled corners.</summary>
    public static CornerCut FromRadius(double radius) => new(radius, radius, radius);

    public bool IsNone => Before == 0.0 && After == 0.0;

    /// <summary>The outline through right-angled corners with each of them cut; where a side is too short for that, the outline unchanged, as in
    /// AutoCAD.</summary>
    public IReadOnlyList<Segment> Apply(IReadOnlyList<Point2D> corners)
    {
        ArgumentNullException.ThrowIfNull(corners);
        var (count, taken) = (corners.Count, Before + After);
        if (IsNone || corners.Select((corner, i) => corner.DistanceTo(corners[(i + 1) % count])).Any(side => side < taken)) return PolygonConstruction.Outline(corners);
        var outline = new List<Segment>();
        for (var i = 0; i < count; i++)
        {
            var (corner, next, behind) = (corners[i], corners[(i + 1) % count], corners[(i + 2) % count]);
            var (from, to) = (Toward(corner, next, After), Toward(next, corner, Before));
            if (from != to) outline.Add(Segment.FromLine(from, to));
            outline.Add(Corner(to, Toward(next, behind, After), (next - corner).Cross(behind - next) > 0.0));
        }

        return outline;
    }

    private static Point2D Toward(Point2D from, Point2D to, double distance) => from + ((to - from) * (distance / from.DistanceTo(to)));

    private Segment Corner(Point2D from, Point2D to, bool isLeft)
    {
        if (Radius == 0.0 || ArcConstruction.FromEndsSweep(from, to, Angle.FromDegrees(isLeft ? 90.0 : -90.0)) is not { } arc) return Segment.FromLine(from, to);
        return Segment.FromArc(arc, from, to);
    }
}
