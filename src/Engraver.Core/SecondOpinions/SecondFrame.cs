namespace Engraver.Core.SecondOpinions;

/// <summary>Where something is drawn: origin and three axes.</summary>
internal readonly record struct SecondFrame(SecondPoint X, SecondPoint Y, SecondPoint Z, SecondPoint Origin)
{
    public static SecondFrame World { get; } = new(new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), new(0, 0, 0));

    /// <summary>The system of an entity with an extrusion direction (DXF reference, "Arbitrary Axis Algorithm").</summary>
    public static SecondFrame OfExtrusion(SecondRecord record)
    {
        var z = new SecondPoint(record.Number(210, 0.0), record.Number(220, 0.0), record.Number(230, 1.0));
        var length = z.To(default);
        if (length == 0.0) return World;
        z = (1.0 / length) * z;
        var x = Math.Abs(z.X) < 1.0 / 64.0 && Math.Abs(z.Y) < 1.0 / 64.0 ? new SecondPoint(z.Z, 0.0, -z.X) : new SecondPoint(-z.Y, z.X, 0.0);
        x = (1.0 / x.To(default)) * x;
        return new SecondFrame(x, new SecondPoint((z.Y * x.Z) - (z.Z * x.Y), (z.Z * x.X) - (z.X * x.Z), (z.X * x.Y) - (z.Y * x.X)), z, default);
    }

    public SecondPoint Direction(SecondPoint p) => (p.X * X) + (p.Y * Y) + (p.Z * Z);

    public SecondPoint At(SecondPoint p) => Direction(p) + Origin;

    /// <summary>The inner frame seen through this one.</summary>
    public SecondFrame Holding(SecondFrame inner) => new(Direction(inner.X), Direction(inner.Y), Direction(inner.Z), At(inner.Origin));
}
