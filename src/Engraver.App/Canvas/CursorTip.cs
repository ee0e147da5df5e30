using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Canvas;

/// <summary>The text beside the crosshair while a command asks for a place: the instruction, and figures of where the cursor is.</summary>
internal static class CursorTip
{
    /// <param name="asked">The instruction of the command; empty for none.</param>
    /// <param name="place">Where a click would be, drawing units.</param>
    /// <param name="figures">How many decimals there are.</param>
    /// <param name="before">Stands before the figures.</param>
    public static string Format(string asked, PointAim aim, Point2D place, Figures figures, string before = "") => aim.Use == PointUse.Object ? asked : $"{asked}\n{before}{Measured(aim, place, figures)}".TrimStart('\n');

    /// <summary>Coordinates of a place that stands alone, sides of a box, else distance and angle (degrees, counter-clockwise from +X) from the point
    /// before.</summary>
    private static string Measured(PointAim aim, Point2D place, Figures figures)
    {
        if (aim.From is not { } from) return $"{figures.MovingLength(place.X)}, {figures.MovingLength(place.Y)}";
        var offset = place - from;
        return aim.Use == PointUse.Corner
            ? $"{figures.MovingLength(Math.Abs(offset.X))} x {figures.MovingLength(Math.Abs(offset.Y))}"
            : $"{figures.MovingLength(offset.Length)} < {figures.MovingDegrees(offset.Length > 0.0 ? offset.Direction.Positive() : Angle.Zero)}\u00B0";
    }
}
