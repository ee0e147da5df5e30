using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>A cubic by its Bezier control points.</summary>
internal readonly record struct Cubic(Point2D A, Point2D B, Point2D C, Point2D D)
{
    public Point2D At(double u)
    {
        var v = 1.0 - u;
        var (a, b, c, d) = (v * v * v, 3.0 * v * v * u, 3.0 * v * u * u, u * u * u);
        return new Point2D((a * A.X) + (b * B.X) + (c * C.X) + (d * D.X), (a * A.Y) + (b * B.Y) + (c * C.Y) + (d * D.Y));
    }

    /// <summary>The derivative by u.</summary>
    public Vector2D SlopeAt(double u)
    {
        var v = 1.0 - u;
        return (((B - A) * (v * v)) + ((C - B) * (2.0 * v * u)) + ((D - C) * (u * u))) * 3.0;
    }

    /// <summary>Both parts when split at a parameter.</summary>
    public (Cubic First, Cubic Second) Split(double u)
    {
        Point2D ab = A + ((B - A) * u), bc = B + ((C - B) * u), cd = C + ((D - C) * u);
        Point2D abc = ab + ((bc - ab) * u), bcd = bc + ((cd - bc) * u);
        var middle = abc + ((bcd - abc) * u);
        return (new Cubic(A, ab, abc, middle), new Cubic(middle, bcd, cd, D));
    }
}
