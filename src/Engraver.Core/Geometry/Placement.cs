namespace Engraver.Core.Geometry;

/// <summary>An affine map of space: axes and origin of a block, or of an entity's own system (OCS), in the world.</summary>
public readonly record struct Placement(Vector3D XAxis, Vector3D YAxis, Vector3D ZAxis, Vector3D Origin)
{
    /// <summary>Extrusions with x and y below this use the world's y axis as helper, others the z axis (DXF reference, "Arbitrary Axis Algorithm").</summary>
    private const double NearWorldZ = 1.0 / 64.0;

    public static Placement Identity { get; } = new(new(1.0, 0.0, 0.0), new(0.0, 1.0, 0.0), new(0.0, 0.0, 1.0), default);

    public bool IsIdentity => this == Identity;

    /// <summary>The entity system that belongs to an extrusion direction. It must not be the zero vector.</summary>
    public static Placement FromExtrusion(Vector3D direction)
    {
        if (direction is { X: 0.0, Y: 0.0 }) return direction.Z > 0.0 ? Identity : new(new(-1.0, 0.0, 0.0), new(0.0, 1.0, 0.0), new(0.0, 0.0, -1.0), default);
        var normal = direction.Unit();
        var helper = Math.Abs(normal.X) < NearWorldZ && Math.Abs(normal.Y) < NearWorldZ ? new Vector3D(0.0, 1.0, 0.0) : new Vector3D(0.0, 0.0, 1.0);
        var x = helper.Cross(normal);
        x = x.Unit();
        return new Placement(x, normal.Cross(x), normal, default);
    }

    /// <summary>Scale, then rotation about z: the transformation of a block by an INSERT, in the insert's own system.</summary>
    public static Placement FromInsert(Vector3D scale, Angle rotation) => new(
        new(scale.X * rotation.Cos(), scale.X * rotation.Sin(), 0.0),
        new(-scale.Y * rotation.Sin(), scale.Y * rotation.Cos(), 0.0),
        new(0.0, 0.0, scale.Z),
        default);

    /// <summary>A similarity of the plane; z is scaled with it.</summary>
    public static Placement FromPlane(Transform2D map)
    {
        var (cos, sin) = (map.Scale * map.Turn.Cos(), map.Scale * map.Turn.Sin());
        var across = map.Mirrored ? new Vector3D(sin, -cos, 0.0) : new Vector3D(-sin, cos, 0.0);
        return new Placement(new(cos, sin, 0.0), across, new(0.0, 0.0, map.Scale), new(map.Shift.X, map.Shift.Y, 0.0));
    }

    public Vector3D Apply(Vector3D point) => ApplyToDirection(point) + Origin;

    public Vector3D ApplyToDirection(Vector3D direction) => (XAxis * direction.X) + (YAxis * direction.Y) + (ZAxis * direction.Z);

    /// <summary>The map that applies <paramref name="inner"/> first, then this.</summary>
    public Placement After(Placement inner) =>
        new(ApplyToDirection(inner.XAxis), ApplyToDirection(inner.YAxis), ApplyToDirection(inner.ZAxis), Apply(inner.Origin));

    public Placement MovedBy(Vector3D displacement) => this with { Origin = Origin + displacement };
}
