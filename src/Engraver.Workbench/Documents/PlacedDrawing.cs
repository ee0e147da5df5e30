using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>Places a drawing as the settings request.</summary>
internal static class PlacedDrawing
{
    /// <param name="drawing">As in its file.</param>
    /// <returns>Unusable if it cannot be placed; the same drawing if it needs no placement.</returns>
    public static Drawing Of(Drawing drawing, DrawingSettings settings)
    {
        if (settings.Placement.IsNone || DrawingFile.IsUnreadable(drawing)) return drawing;
        return Try(drawing, settings, Transform2D.Identity) ?? Drawing.Unusable(drawing.FileName, drawing.Bytes, PlacementRules.OutOfRange.At(default));
    }

    /// <summary>The drawing with another placement than the one that it has.</summary>
    /// <param name="back">The map from its present coordinates to those of its file.</param>
    /// <returns>Null if a coordinate would leave the range of a drawing.</returns>
    public static Drawing? Try(Drawing drawing, DrawingSettings settings, Transform2D back)
    {
        var map = settings.Placement.MapIn(drawing.Scale);
        return MappedDrawing.Try(drawing, back == Transform2D.Identity ? map : map.After(back), out var placed) ? placed with { Placement = settings.Placement, PlacementMap = map } : null;
    }
}
