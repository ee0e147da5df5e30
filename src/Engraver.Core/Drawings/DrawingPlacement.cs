using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>Where a drawing is cut: scaled, mirrored and rotated about its zero, placed on the blank or aligned, moved, turned over with the blank; in this
/// order. The unit of the drawing comes before, so that lengths here are millimetres.</summary>
public sealed record DrawingPlacement
{
    /// <summary>The drawing as it is in its file.</summary>
    public static DrawingPlacement None { get; } = new();

    /// <summary>Uniform factor, also for heights; above 0.</summary>
    public double Scale { get; init; } = 1.0;

    public MirrorAxis Mirror { get; init; }

    /// <summary>Counter-clockwise.</summary>
    public Angle Rotation { get; init; }

    public BlankPlace Place { get; init; }

    /// <summary>Points of the drawing, scaled, mirrored and rotated, that are cut at <see cref="To"/>; null for none.</summary>
    public PointPair? Align { get; init; }

    /// <summary>Points of the machine, from the work origin.</summary>
    public PointPair? To { get; init; }

    /// <summary>Largest difference of the distances of the two pairs.</summary>
    public double AlignTolerance { get; init; } = 0.1;

    /// <summary>Millimetres.</summary>
    public Vector2D Move { get; init; }

    /// <summary>Width and height of the blank, whose lower left corner is 0,0; zero where it is not stated.</summary>
    public Vector2D Blank { get; init; }

    /// <summary>The axis about which the blank is turned over.</summary>
    public MirrorAxis Back { get; init; }

    public bool IsNone => this == None;

    /// <summary>Scale, mirror and rotation, the same in every unit.</summary>
    public Transform2D Shape => new(Scale, Rotation + HalfTurn(Mirror), Mirror != MirrorAxis.None, default);

    /// <summary>What comes after the alignment: the move, and turning over; millimetres.</summary>
    public Transform2D AfterAlignment => Back == MirrorAxis.None ? Transform2D.Move(Move) : TurnedOver.After(Transform2D.Move(Move));

    private Transform2D TurnedOver => new(1.0, HalfTurn(Back), true, Back == MirrorAxis.X ? new Vector2D(0.0, Blank.Y) : new Vector2D(Blank.X, 0.0));

    /// <summary>The difference of the distances of the two pairs of points; 0 without them.</summary>
    public double AlignError => Align is { } from && To is { } to ? Math.Abs(to.Span.Length - from.Span.Length) : 0.0;

    /// <summary>The whole map of the plane, drawing units to drawing units.</summary>
    /// <param name="scale">Of the drawing.</param>
    /// <param name="shaped">Box of what is cut under <see cref="Shape"/>, millimetres; used only with <see cref="Place"/>.</param>
    public Transform2D MapIn(DrawingScale scale, Bounds2D shaped)
    {
        var map = Shape;
        if (Place != BlankPlace.None) map = Transform2D.Move(PlaceShift(shaped)).After(map);
        if (Align is { } from && To is { } to) map = Alignment(from, to).After(map);
        map = Transform2D.Move(Move).After(map);
        if (Back != MirrorAxis.None) map = TurnedOver.After(map);
        return map with { Shift = new Vector2D(scale.ToDrawing(map.Shift.X), scale.ToDrawing(map.Shift.Y)) };
    }

    /// <summary>The displacement that puts a box at its place on the blank.</summary>
    public Vector2D PlaceShift(Bounds2D box) => Place switch
    {
        BlankPlace.Corner => new Vector2D(-box.MinX, -box.MinY),
        BlankPlace.Centre => new Vector2D((Blank.X - box.MinX - box.MaxX) / 2.0, (Blank.Y - box.MinY - box.MaxY) / 2.0),
        _ => default,
    };

    /// <summary>A displacement on the front of the blank as it is on the side that is cut.</summary>
    public Vector2D Turned(Vector2D displacement) => Back switch
    {
        MirrorAxis.X => displacement with { Y = -displacement.Y },
        MirrorAxis.Y => displacement with { X = -displacement.X },
        _ => displacement,
    };

    /// <summary>About Y is about X, and half a turn.</summary>
    private static Angle HalfTurn(MirrorAxis axis) => axis == MirrorAxis.Y ? Angle.FromDegrees(180.0) : Angle.Zero;

    /// <summary>Rotation and displacement: the middles coincide, so that both points have half of the difference of the distances.</summary>
    private static Transform2D Alignment(PointPair from, PointPair to)
    {
        var turn = new Transform2D(1.0, (to.Span.Direction - from.Span.Direction).Positive(), false, default);
        return turn with { Shift = to.Middle - turn.Apply(from.Middle) };
    }
}
