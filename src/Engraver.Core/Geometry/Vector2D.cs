namespace Engraver.Core.Geometry;

/// <summary>A displacement in the plane.</summary>
public readonly record struct Vector2D(double X, double Y)
{
    public double LengthSquared => (X * X) + (Y * Y);

    public double Length => double.Hypot(X, Y);

    /// <summary>Direction in (-180, 180] degrees; 0 for the zero vector.</summary>
    public Angle Direction => Angle.Direction(X, Y);

    public static Vector2D FromPolar(double length, Angle direction) => new(length * direction.Cos(), length * direction.Sin());

    public double Dot(Vector2D other) => (X * other.X) + (Y * other.Y);

    /// <summary>z of the cross product: positive when <paramref name="other"/> is to the left.</summary>
    public double Cross(Vector2D other) => (X * other.Y) - (Y * other.X);

    /// <summary>Signed turn from this direction to the other, in (-180, 180] degrees, left turn positive; 0 when either vector is zero.</summary>
    public Angle TurnTo(Vector2D other) => Angle.Direction(Dot(other), Cross(other));

    public static Vector2D operator +(Vector2D left, Vector2D right) => new(left.X + right.X, left.Y + right.Y);

    public static Vector2D operator -(Vector2D left, Vector2D right) => new(left.X - right.X, left.Y - right.Y);

    public static Vector2D operator -(Vector2D vector) => new(-vector.X, -vector.Y);

    public static Vector2D operator *(Vector2D vector, double factor) => new(vector.X * factor, vector.Y * factor);
}
