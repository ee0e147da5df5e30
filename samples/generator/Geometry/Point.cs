namespace Engraver.Samples.Geometry;

/// <summary>A place in the drawing plane, in drawing units; also used as an offset from the origin.</summary>
internal readonly record struct Point(double X, double Y)
{
    /// <summary>The point at <paramref name="radius"/> from the origin; degrees run counter-clockwise from the X axis.</summary>
    public static Point Polar(double radius, double degrees)
    {
        var (sine, cosine) = Math.SinCos(double.DegreesToRadians(degrees));
        return new(radius * cosine, radius * sine);
    }

    public double Length => Math.Sqrt((X * X) + (Y * Y));

    /// <summary>Direction from the origin in degrees, from -180 to 180.</summary>
    public double Degrees => double.RadiansToDegrees(Math.Atan2(Y, X));

    /// <summary>A quarter turn counter-clockwise.</summary>
    public Point Left => new(-Y, X);

    public static Point operator +(Point a, Point b) => new(a.X + b.X, a.Y + b.Y);

    public static Point operator -(Point a, Point b) => new(a.X - b.X, a.Y - b.Y);

    public static Point operator *(Point a, double factor) => new(a.X * factor, a.Y * factor);

    /// <summary>Turned counter-clockwise about the origin.</summary>
    public Point Rotated(double degrees)
    {
        var turn = Polar(1, degrees);
        return new((X * turn.X) - (Y * turn.Y), (X * turn.Y) + (Y * turn.X));
    }
}
