namespace Engraver.Core.Geometry;

/// <summary>A similarity of the plane: mirror in the x axis (or not), scale, rotate, translate, in this order. Lines remain lines and arcs remain arcs,
/// exactly.</summary>
/// <param name="Scale">Above 0; one factor for both axes.</param>
/// <param name="Turn">Rotation, counter-clockwise; quarter turns are exact.</param>
/// <param name="Mirrored">True when left and right are exchanged (arcs change their sign).</param>
/// <param name="Shift">Translation: the image of the origin.</param>
public readonly record struct Transform2D(double Scale, Angle Turn, bool Mirrored, Vector2D Shift)
{
    public static Transform2D Identity { get; } = new(1.0, Angle.Zero, false, default);

    public static Transform2D Move(Vector2D by) => Identity with { Shift = by };

    public static Transform2D Rotate(Point2D about, Angle by) => new Transform2D(1.0, by, false, default).Keeping(about);

    public static Transform2D ScaleFrom(Point2D basePoint, double factor) => new Transform2D(factor, Angle.Zero, false, default).Keeping(basePoint);

    /// <summary>Mirror in the line through two points; they must differ.</summary>
    public static Transform2D MirrorAt(Point2D a, Point2D b) => new Transform2D(1.0, (b - a).Direction * 2.0, true, default).Keeping(a);

    public Point2D Apply(Point2D point) => Point2D.Origin + Linear(new Vector2D(point.X, point.Y)) + Shift;

    /// <summary>Maps an arc; a whole turn remains a sweep of exactly +-360 degrees.</summary>
    public ArcSegment Apply(ArcSegment arc) => new(
        Apply(arc.Centre),
        arc.Radius * Scale,
        (Mirrored ? Turn - arc.Start : Turn + arc.Start).Positive(),
        Mirrored ? -arc.Sweep : arc.Sweep);

    /// <summary>The map that applies <paramref name="inner"/> first, then this.</summary>
    public Transform2D After(Transform2D inner) => new(
        Scale * inner.Scale,
        (Mirrored ? Turn - inner.Turn : Turn + inner.Turn).Positive(),
        Mirrored ^ inner.Mirrored,
        Linear(inner.Shift) + Shift);

    /// <summary>The map back.</summary>
    public Transform2D Inverse()
    {
        var back = new Transform2D(1.0 / Scale, Mirrored ? Turn : (-Turn).Positive(), Mirrored, default);
        return back with { Shift = -back.Linear(Shift) };
    }

    private Vector2D Linear(Vector2D vector)
    {
        var y = Mirrored ? -vector.Y : vector.Y;
        var (cos, sin) = (Turn.Cos(), Turn.Sin());
        return new Vector2D(Scale * ((vector.X * cos) - (y * sin)), Scale * ((vector.X * sin) + (y * cos)));
    }

    /// <summary>The same map with another translation, so that this point is not moved.</summary>
    private Transform2D Keeping(Point2D point)
    {
        var position = new Vector2D(point.X, point.Y);
        return this with { Shift = position - Linear(position) };
    }
}
