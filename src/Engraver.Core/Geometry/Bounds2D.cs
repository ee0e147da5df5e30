namespace Engraver.Core.Geometry;

/// <summary>An axis-parallel box. <see cref="Empty"/> (not <c>default</c>, which is the origin) contains nothing and is neutral in unions.</summary>
public readonly record struct Bounds2D(double MinX, double MinY, double MaxX, double MaxY)
{
    public static Bounds2D Empty => new(double.PositiveInfinity, double.PositiveInfinity, double.NegativeInfinity, double.NegativeInfinity);

    public bool IsEmpty => !(MinX <= MaxX && MinY <= MaxY);

    public double Width => IsEmpty ? 0.0 : MaxX - MinX;

    public double Height => IsEmpty ? 0.0 : MaxY - MinY;

    public static Bounds2D FromCorners(Point2D a, Point2D b) => new(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Max(a.X, b.X), Math.Max(a.Y, b.Y));

    public Bounds2D Including(Point2D point) =>
        new(Math.Min(MinX, point.X), Math.Min(MinY, point.Y), Math.Max(MaxX, point.X), Math.Max(MaxY, point.Y));

    public Bounds2D Union(Bounds2D other) =>
        new(Math.Min(MinX, other.MinX), Math.Min(MinY, other.MinY), Math.Max(MaxX, other.MaxX), Math.Max(MaxY, other.MaxY));

    public Bounds2D Grown(double by) => new(MinX - by, MinY - by, MaxX + by, MaxY + by);

    public bool Contains(Point2D point) => point.X >= MinX && point.X <= MaxX && point.Y >= MinY && point.Y <= MaxY;

    public bool Contains(Bounds2D other) => other.MinX >= MinX && other.MaxX <= MaxX && other.MinY >= MinY && other.MaxY <= MaxY;
}
