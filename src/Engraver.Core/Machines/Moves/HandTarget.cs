using Engraver.Core.Geometry;

namespace Engraver.Core.Machines.Moves;

/// <summary>The target of a move by hand, in the controller's own counts; null where it is outside the controller's range of counts.</summary>
public static class HandTarget
{
    /// <summary>A machine position, mm.</summary>
    public static CountsPoint? OfMachine(Point2D place, CountsScale scale) => scale.IsInRange(Bounds2D.FromCorners(place, place), default) ? scale.ToCounts(place) : null;

    /// <summary>A point of the drawing, mm.</summary>
    /// <param name="zero">Controller counts of the drawing's zero.</param>
    public static CountsPoint? OfDrawing(Point2D place, CountsPoint zero, CountsScale scale)
    {
        if (!scale.IsInRange(Bounds2D.FromCorners(place, place), new CountsPoint(-zero.X, -zero.Y))) return null;
        var at = scale.ToCounts(place);
        return new CountsPoint(at.X + zero.X, at.Y + zero.Y);
    }

    /// <summary>A step from the present position of the machine.</summary>
    /// <param name="here">Machine position, mm.</param>
    /// <param name="height">Machine height, mm.</param>
    /// <param name="up">Step of the height, mm; up positive.</param>
    public static CountsPoint? FromStep(Point2D here, double height, Vector2D step, double up, CountsScale scale) =>
        OfMachine(here + step, scale) is { } goal && scale.IsHeightInRange(height + up) ? goal with { Z = scale.ToHeight(height + up) } : null;

    /// <summary>Straight above or below a machine position, at the clearance height above the work.</summary>
    /// <param name="zero">Controller counts of the drawing's zero.</param>
    public static CountsPoint? AtClearance(Point2D here, CountsPoint zero, MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return OfMachine(here, profile.Scale) is { } goal ? goal with { Z = zero.Z + profile.ClearanceCounts } : null;
    }
}
