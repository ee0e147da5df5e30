namespace Engraver.Core.Geometry.Constructions;

/// <summary>Corners of regular polygons and of rectangles, in the order in which they are drawn.</summary>
public static class PolygonConstruction
{
    /// <summary>Counter-clockwise about a centre, from a corner.</summary>
    public static IReadOnlyList<Point2D> Inscribed(Point2D centre, Point2D corner, int sides)
    {
        var spoke = corner - centre;
        var (radius, first) = (spoke.Length, spoke.Direction);
        return [.. Enumerable.Range(0, sides).Select(side => side == 0 ? corner : centre + Vector2D.FromPolar(radius, first + Angle.FromDegrees(360.0 * side / sides)))];
    }

    /// <summary>Counter-clockwise about a centre, from the corner after a side.</summary>
    /// <param name="middle">Midpoint of that side, where the inscribed circle touches it.</param>
    public static IReadOnlyList<Point2D> Circumscribed(Point2D centre, Point2D middle, int sides)
    {
        var spoke = middle - centre;
        var half = Angle.FromDegrees(180.0 / sides);
        return Inscribed(centre, centre + Vector2D.FromPolar(spoke.Length / half.Cos(), spoke.Direction + half), sides);
    }

    /// <summary>Counter-clockwise from the first end of a side through its second.</summary>
    public static IReadOnlyList<Point2D> OnEdge(Point2D first, Point2D second, int sides)
    {
        var half = Angle.FromDegrees(180.0 / sides);
        var (edge, middle) = (second - first, first + ((second - first) * 0.5));
        var centre = middle + (new Vector2D(-edge.Y, edge.X) * (half.Cos() / (2.0 * half.Sin())));
        var corners = Inscribed(centre, first, sides).ToArray();
        corners[1] = second;
        return corners;
    }

    /// <summary>From a corner along the first side to the opposite corner and back.</summary>
    /// <param name="sides">From the corner to the opposite one, along the first side and across; negative to the other side.</param>
    /// <param name="turn">Angle of the first side to +X.</param>
    public static IReadOnlyList<Point2D> Rectangle(Point2D corner, Vector2D sides, Angle turn)
    {
        var (along, across) = (Vector2D.FromPolar(sides.X, turn), Vector2D.FromPolar(sides.Y, turn + Angle.FromDegrees(90.0)));
        return [corner, corner + along, corner + along + across, corner + across];
    }

    /// <summary>The vector between two corners of a rectangle, along its first side and across.</summary>
    public static Vector2D SidesOf(Point2D corner, Point2D opposite, Angle turn)
    {
        var (diagonal, cos, sin) = (opposite - corner, turn.Cos(), turn.Sin());
        return new Vector2D((diagonal.X * cos) + (diagonal.Y * sin), (diagonal.Y * cos) - (diagonal.X * sin));
    }

    /// <summary>The closed outline through corners.</summary>
    public static IReadOnlyList<Segment> Outline(IReadOnlyList<Point2D> corners) => [.. corners.Select((corner, i) => Segment.FromLine(corner, corners[(i + 1) % corners.Count]))];
}
