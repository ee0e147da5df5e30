namespace Engraver.Samples.Geometry;

/// <summary>Closed contours that drawings are full of. All run counter-clockwise, and every arc meets its neighbours tangentially.</summary>
internal static class Shapes
{
    /// <summary>Angle, seen from the larger circle's centre, between the axis and the point where the common outer tangent touches.</summary>
    public static double TangentDegrees(double radius, double otherRadius, double distance) =>
        double.RadiansToDegrees(Math.Acos((radius - otherRadius) / distance));

    /// <summary>A belt around two circles: a tapered link, or a slot where the radii are equal.</summary>
    public static Contour Belt(Point a, double radiusA, Point b, double radiusB)
    {
        var axis = b - a;
        var touch = TangentDegrees(radiusA, radiusB, axis.Length);
        return Pen.At(a + Point.Polar(radiusA, axis.Degrees - touch))
            .LineTo(b + Point.Polar(radiusB, axis.Degrees - touch))
            .ArcAbout(b, 2 * touch)
            .LineTo(a + Point.Polar(radiusA, axis.Degrees + touch))
            .CloseWithArc(360 - (2 * touch));
    }

    public static Contour Slot(double fromX, double fromY, double toX, double toY, double radius) =>
        Belt(new(fromX, fromY), radius, new(toX, toY), radius);

    public static Contour RoundedRectangle(double left, double bottom, double width, double height, double radius) => Rounded(
    [
        new(left, bottom, radius),
        new(left + width, bottom, radius),
        new(left + width, bottom + height, radius),
        new(left, bottom + height, radius),
    ]);

    /// <summary>A circle as two half-turn arcs, the way polylines draw it.</summary>
    public static Contour Ring(double radius) => Pen.At(radius, 0).ArcTo(-radius, 0, 180).CloseWithArc(180);

    /// <summary>The polygon through the corners with each corner replaced by its tangent arc. Edges must be longer than the arcs eat up.</summary>
    public static Contour Rounded(IReadOnlyList<Corner> corners)
    {
        var vertices = new List<Vertex>(2 * corners.Count);
        for (var i = 0; i < corners.Count; i++)
        {
            vertices.AddRange(RoundedCorner(corners[(i + corners.Count - 1) % corners.Count].At, corners[i], corners[(i + 1) % corners.Count].At));
        }

        return new Contour(vertices, Closed: true);
    }

    private static IEnumerable<Vertex> RoundedCorner(Point before, Corner corner, Point after)
    {
        if (corner.Radius == 0)
        {
            return [new Vertex(corner.At)];
        }

        var (arriving, leaving) = (corner.At - before, after - corner.At);
        var turn = double.DegreesToRadians(Math.IEEERemainder(leaving.Degrees - arriving.Degrees, 360));
        var setback = corner.Radius * Math.Tan(Math.Abs(turn) / 2);
        return
        [
            new Vertex(corner.At - (arriving * (setback / arriving.Length)), Math.Tan(turn / 4)),
            new Vertex(corner.At + (leaving * (setback / leaving.Length))),
        ];
    }
}
