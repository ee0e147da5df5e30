using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Canvas;

/// <summary>The text beside the crosshair while a command requests a point: the instruction, and the coordinates of the cursor.</summary>
internal static class CursorTip
{
    /// <param name="asked">The instruction of the command; empty for none.</param>
    /// <param name="place">The point that a click would give, drawing units.</param>
    /// <param name="figures">The number of decimals.</param>
    /// <param name="before">Text before the figures.</param>
    public static string Format(string asked, PointAim aim, Point2D place, Figures figures, string before = "") => aim.Use == PointUse.Object ? asked : $"{asked}\n{before}{Measured(aim, place, figures)}".TrimStart('\n');

    /// <summary>The coordinates if there is no previous point, the sides of a box, otherwise distance and angle (degrees, counter-clockwise from +X) from
    /// the previous point.</summary>
    private static string Measured(PointAim aim, Point2D place, Figures figures)
    {
        if (aim.From is not { } from) return $"{figures.MovingLength(place.X)}, {figures.MovingLength(place.Y)}";
        var offset = place - from;
        return aim.Use == PointUse.Corner
            ? $"{figures.MovingLength(Math.Abs(offset.X))} x {figures.MovingLength(Math.Abs(offset.Y))}"
            : $"{figures.MovingLength(offset.Length)} < {figures.MovingDegrees(offset.Length > 0.0 ? offset.Direction.Positive() : Angle.Zero)}\u00B0";
    }
}
