using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Desk;

/// <summary>Direct distance entry (hmi-conventions.md section 4): a number alone at a prompt for a point is a distance from the previous point towards the
/// cursor.</summary>
internal static class DirectDistance
{
    /// <param name="typed">The typed text.</param>
    /// <param name="from">The point from which distances are measured, drawing units; null if the prompt has no previous point.</param>
    /// <param name="cursor">The point that a click would give, with object snaps and ORTHO; null if there is none.</param>
    /// <returns>The coordinates of the point, or the typed text if it is not a distance. Replaying the journal of a session gives the same point.</returns>
    public static string Read(string typed, Point2D? from, Point2D? cursor)
    {
        if (from is not { } start || cursor is not { } aimed || aimed == start || !NumberPrompt.TryParse(typed.Trim(), out var distance)) return typed;
        var way = aimed - start;
        var place = start + (way * (distance / way.Length));
        return place.IsFinite ? string.Create(CultureInfo.InvariantCulture, $"{place.X:R},{place.Y:R}") : typed;
    }
}
