namespace Engraver.Core.Geometry;

/// <summary>A point of the plane. <c>==</c> is exact; nearness is <see cref="IsNear"/> with a named tolerance.</summary>
public readonly record struct Point2D(double X, double Y)
{
    public static Point2D Origin => default;

    public bool IsFinite => double.IsFinite(X) && double.IsFinite(Y);

    public double DistanceTo(Point2D other) => (other - this).Length;

    public bool IsNear(Point2D other, double tolerance) => (other - this).LengthSquared <= tolerance * tolerance;

    public static Point2D operator +(Point2D point, Vector2D by) => new(point.X + by.X, point.Y + by.Y);

    public static Point2D operator -(Point2D point, Vector2D by) => new(point.X - by.X, point.Y - by.Y);

    public static Vector2D operator -(Point2D to, Point2D from) => new(to.X - from.X, to.Y - from.Y);
}
