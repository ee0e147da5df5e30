namespace Engraver.Core.Geometry;

/// <summary>A point or displacement in space, drawing units. The reader needs z for tilted and elevated entities; later stages work in plan.</summary>
public readonly record struct Vector3D(double X, double Y, double Z)
{
    public double Length => Math.Sqrt(Dot(this));

    /// <summary>The same direction with length 1, also when the squares of the components underflow or overflow. Not for the zero vector.</summary>
    public Vector3D Unit()
    {
        var scaled = this * (1.0 / Math.Max(Math.Max(Math.Abs(X), Math.Abs(Y)), Math.Abs(Z)));
        return scaled * (1.0 / scaled.Length);
    }

    /// <summary>The point under a similarity of the plane; z is scaled with it.</summary>
    public Vector3D Transformed(Transform2D map)
    {
        var plan = map.Apply(new Point2D(X, Y));
        return new Vector3D(plan.X, plan.Y, Z * map.Scale);
    }

    public double Dot(Vector3D other) => (X * other.X) + (Y * other.Y) + (Z * other.Z);

    public Vector3D Cross(Vector3D other) => new((Y * other.Z) - (Z * other.Y), (Z * other.X) - (X * other.Z), (X * other.Y) - (Y * other.X));

    public static Vector3D operator +(Vector3D left, Vector3D right) => new(left.X + right.X, left.Y + right.Y, left.Z + right.Z);

    public static Vector3D operator -(Vector3D left, Vector3D right) => new(left.X - right.X, left.Y - right.Y, left.Z - right.Z);

    public static Vector3D operator *(Vector3D vector, double factor) => new(vector.X * factor, vector.Y * factor, vector.Z * factor);
}
