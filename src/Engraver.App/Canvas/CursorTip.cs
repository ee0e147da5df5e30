using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Canvas;

/// <summary>The text beside the crosshair while a command asks for a place: the instruction, and figures of where the cursor is.</summary>
internal static class CursorTip
{
    /// <param name="asked">The instruction of the command; empty for none.</param>
    /// <param name="place">Where a click would be, drawing units.</param>
    /// <param name="before">Stands before the figures.</param>
    public static string Format(string asked, PointAim aim, Point2D place, string before = "") => aim.Use == PointUse.Object ? asked : $"{asked}\n{before}{Figures(aim, place)}".TrimStart('\n');

    /// <summary>Coordinates of a place that stands alone, sides of a box, else distance and angle (degrees, counter-clockwise from +X) from the point before.</summary>
    private static string Figures(PointAim aim, Point2D place)
    {
        if (aim.From is not { } from) return string.Create(CultureInfo.InvariantCulture, $"{place.X:0.0000}, {place.Y:0.0000}");
        var offset = place - from;
        return aim.Use == PointUse.Corner
            ? string.Create(CultureInfo.InvariantCulture, $"{Math.Abs(offset.X):0.0000} x {Math.Abs(offset.Y):0.0000}")
            : string.Create(CultureInfo.InvariantCulture, $"{offset.Length:0.0000} < {(offset.Length > 0.0 ? offset.Direction.Positive().Degrees : 0.0):0.00}\u00B0");
    }
}
