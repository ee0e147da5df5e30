namespace Engraver.Tools.CrossChecks;

/// <summary>A coordinate system: origin and three axes.</summary>
internal readonly record struct CrossCheckFrame(CrossCheckPoint X, CrossCheckPoint Y, CrossCheckPoint Z, CrossCheckPoint Origin)
{
    public static CrossCheckFrame World { get; } = new(new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), new(0, 0, 0));

    /// <summary>The system of an entity with an extrusion direction (DXF reference, "Arbitrary Axis Algorithm").</summary>
    public static CrossCheckFrame FromExtrusion(CrossCheckRecord record)
    {
        var z = new CrossCheckPoint(record.Number(210, 0.0), record.Number(220, 0.0), record.Number(230, 1.0));
        var length = z.To(default);
        if (length == 0.0) return World;
        z = (1.0 / length) * z;
        var x = Math.Abs(z.X) < 1.0 / 64.0 && Math.Abs(z.Y) < 1.0 / 64.0 ? new CrossCheckPoint(z.Z, 0.0, -z.X) : new CrossCheckPoint(-z.Y, z.X, 0.0);
        x = (1.0 / x.To(default)) * x;
        return new CrossCheckFrame(x, new CrossCheckPoint((z.Y * x.Z) - (z.Z * x.Y), (z.Z * x.X) - (z.X * x.Z), (z.X * x.Y) - (z.Y * x.X)), z, default);
    }

    public CrossCheckPoint Direction(CrossCheckPoint p) => (p.X * X) + (p.Y * Y) + (p.Z * Z);

    public CrossCheckPoint At(CrossCheckPoint p) => Direction(p) + Origin;

    /// <summary>The inner frame as seen through this one.</summary>
    public CrossCheckFrame Compose(CrossCheckFrame inner) => new(Direction(inner.X), Direction(inner.Y), Direction(inner.Z), At(inner.Origin));
}

/// <summary>A point in space, drawing units.</summary>
internal readonly record struct CrossCheckPoint(double X, double Y, double Z)
{
    public static CrossCheckPoint operator +(CrossCheckPoint a, CrossCheckPoint b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static CrossCheckPoint operator -(CrossCheckPoint a, CrossCheckPoint b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static CrossCheckPoint operator *(double f, CrossCheckPoint a) => new(f * a.X, f * a.Y, f * a.Z);

    public double To(CrossCheckPoint other) => Math.Sqrt(((X - other.X) * (X - other.X)) + ((Y - other.Y) * (Y - other.Y)) + ((Z - other.Z) * (Z - other.Z)));
}
