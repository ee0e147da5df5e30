using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Canvas;

/// <summary>The text beside the crosshair while a command requests a point: the instruction, and the coordinates of the cursor.</summary>
internal static class CursorTip
{
    /// <param name="instruction">The instruction of the command; empty for none.</param>
    /// <param name="place">The point that a click would give, drawing units.</param>
    /// <param name="figures">The number of decimals.</param>
    /// <param name="before">Text before the figures.</param>
    public static string Format(string instruction, PointRequest aim, Point2D place, DisplayPrecision figures, string before = "") => aim.Purpose == PointPurpose.Object ? instruction : $"{instruction}\n{before}{Measured(aim, place, figures)}".TrimStart('\n');

    /// <summary>The coordinates if there is no previous point, the sides of a box, otherwise distance and angle (degrees, counter-clockwise from +X) from
    /// the previous point.</summary>
    private static string Measured(PointRequest aim, Point2D place, DisplayPrecision figures)
    {
        if (aim.From is not { } from) return $"{figures.FormatCursorLength(place.X)}, {figures.FormatCursorLength(place.Y)}";
        var offset = place - from;
        return aim.Purpose == PointPurpose.Corner
            ? $"{figures.FormatCursorLength(Math.Abs(offset.X))} x {figures.FormatCursorLength(Math.Abs(offset.Y))}"
            : $"{figures.FormatCursorLength(offset.Length)} < {figures.FormatCursorDegrees(offset.Length > 0.0 ? offset.Direction.Positive() : Angle.Zero)}\u00B0";
    }
}
