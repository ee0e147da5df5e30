using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>Where a drawing is cut: scaled, then mirrored, then rotated, all about its zero, then moved. The unit of the drawing comes before, so that
/// lengths here are millimetres.</summary>
public sealed record DrawingPlacement
{
    /// <summary>The drawing as it is in its file.</summary>
    public static DrawingPlacement None { get; } = new();

    /// <summary>Uniform factor, also for heights; above 0.</summary>
    public double Scale { get; init; } = 1.0;

    public MirrorAxis Mirror { get; init; }

    /// <summary>Counter-clockwise.</summary>
    public Angle Rotation { get; init; }

    /// <summary>Millimetres.</summary>
    public Vector2D Move { get; init; }

    public bool IsNone => this == None;

    /// <summary>The map of the plane, drawing units to drawing units.</summary>
    /// <param name="scale">Of the drawing.</param>
    public Transform2D MapIn(DrawingScale scale)
    {
        var isMirrored = Mirror != MirrorAxis.None;
        var halfTurn = Mirror == MirrorAxis.Y ? Angle.FromDegrees(180.0) : Angle.Zero; // about Y: about X, and half a turn
        return new Transform2D(Scale, Rotation + halfTurn, isMirrored, new Vector2D(scale.ToDrawing(Move.X), scale.ToDrawing(Move.Y)));
    }
}
