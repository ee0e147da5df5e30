using Engraver.Core.Geometry;

namespace Engraver.Core.Machines.Moves;

/// <summary>Where a move by hand goes, in the controller's own counts; null where that is more than a controller counts.</summary>
public static class HandPlace
{
    /// <summary>A machine position, mm.</summary>
    public static CountsPoint? OfMachine(Point2D place, CountsScale scale) => scale.Holds(Bounds2D.FromCorners(place, place), default) ? scale.ToCounts(place) : null;

    /// <summary>A place of the drawing, mm.</summary>
    /// <param name="zero">Where the drawing's zero lies.</param>
    public static CountsPoint? OfDrawing(Point2D place, CountsPoint zero, CountsScale scale)
    {
        if (!scale.Holds(Bounds2D.FromCorners(place, place), new CountsPoint(-zero.X, -zero.Y))) return null;
        var at = scale.ToCounts(place);
        return new CountsPoint(at.X + zero.X, at.Y + zero.Y);
    }

    /// <summary>A step from where the machine stands.</summary>
    /// <param name="here">Machine position, mm.</param>
    /// <param name="height">Machine height, mm.</param>
    /// <param name="up">Up or down, mm.</param>
    public static CountsPoint? Beside(Point2D here, double height, Vector2D step, double up, CountsScale scale) =>
        OfMachine(here + step, scale) is { } goal && scale.HoldsHeight(height + up) ? goal with { Z = scale.ToHeight(height + up) } : null;

    /// <summary>Straight over or under a machine position, at the clearance height over the work.</summary>
    /// <param name="zero">Where the drawing's zero lies.</param>
    public static CountsPoint? AtClearance(Point2D here, CountsPoint zero, MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return OfMachine(here, profile.Scale) is { } goal ? goal with { Z = zero.Z + profile.ClearanceCounts } : null;
    }
}
