namespace Engraver.Core.SecondOpinions;

/// <summary>A place in space.</summary>
internal readonly record struct SecondPoint(double X, double Y, double Z)
{
    public static SecondPoint operator +(SecondPoint a, SecondPoint b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static SecondPoint operator -(SecondPoint a, SecondPoint b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static SecondPoint operator *(double f, SecondPoint a) => new(f * a.X, f * a.Y, f * a.Z);

    public double To(SecondPoint other) => Math.Sqrt(((X - other.X) * (X - other.X)) + ((Y - other.Y) * (Y - other.Y)) + ((Z - other.Z) * (Z - other.Z)));
}
