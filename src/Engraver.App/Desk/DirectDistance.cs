using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Desk;

/// <summary>Direct distance entry (hmi-conventions.md section 4): a number alone, where a place is asked for, goes that far from the place before towards
/// the cursor.</summary>
internal static class DirectDistance
{
    /// <param name="typed">What was typed.</param>
    /// <param name="from">Where distances are measured from, drawing units; null when no place is asked for that has one before it.</param>
    /// <param name="cursor">The place that a click would give, with object snaps and ORTHO; null when there is none.</param>
    /// <returns>The place as coordinates, or what was typed where it is no distance. A session's journal then leads to the same place again.</returns>
    public static string Read(string typed, Point2D? from, Point2D? cursor)
    {
        if (from is not { } start || cursor is not { } aimed || aimed == start || !NumberPrompt.TryNumber(typed.Trim(), out var distance)) return typed;
        var way = aimed - start;
        var place = start + (way * (distance / way.Length));
        return place.IsFinite ? string.Create(CultureInfo.InvariantCulture, $"{place.X:R},{place.Y:R}") : typed;
    }
}
