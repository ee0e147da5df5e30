namespace Engraver.Benchmarks.Motion;

/// <summary>A point or a vector in the plane, millimetres.</summary>
internal readonly record struct Plane(double X, double Y)
{
    public double Length => double.Hypot(X, Y);

    /// <summary>Turned to the left by 90 degrees.</summary>
    public Plane Left => new(-Y, X);

    public static Plane operator +(Plane a, Plane b) => new(a.X + b.X, a.Y + b.Y);

    public static Plane operator -(Plane a, Plane b) => new(a.X - b.X, a.Y - b.Y);

    public static Plane operator *(Plane a, double factor) => new(a.X * factor, a.Y * factor);

    public static Plane At(double angle) => new(Math.Cos(angle), Math.Sin(angle));

    public double Dot(Plane other) => (X * other.X) + (Y * other.Y);

    /// <summary>Angle from this direction to another one, radians, positive to the left.</summary>
    public double TurnTo(Plane other) => Math.Atan2((X * other.Y) - (Y * other.X), Dot(other));
}
