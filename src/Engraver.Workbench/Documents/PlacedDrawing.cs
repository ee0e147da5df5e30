using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>Places a drawing as the settings request.</summary>
internal static class PlacedDrawing
{
    /// <param name="drawing">As in its file.</param>
    /// <returns>Unusable if it cannot be placed; the same drawing if it needs no placement.</returns>
    public static Drawing Of(Drawing drawing, DrawingSettings settings)
    {
        if (settings.Placement.IsNone || DrawingFile.IsUnreadable(drawing)) return drawing;
        var (placed, refusal) = Try(drawing, settings, Transform2D.Identity);
        return placed ?? Drawing.Unusable(drawing.FileName, drawing.Bytes, refusal!);
    }

    /// <summary>The drawing with another placement than the one that it has.</summary>
    /// <param name="back">The map from its present coordinates to those of its file.</param>
    /// <returns>The drawing; or why it cannot be placed so.</returns>
    public static (Drawing? Placed, Diagnostic? Refusal) Try(Drawing drawing, DrawingSettings settings, Transform2D back)
    {
        var (placement, box) = (settings.Placement, Bounds2D.Empty);
        if (placement.Place != BlankPlace.None)
        {
            if (!MappedDrawing.Try(drawing, Joined(placement.Shape, back), out var shaped)) return (null, PlacementRules.OutOfRange.At(default));
            box = CutBoundsOf(shaped, settings);
            if (box.IsEmpty) return (null, PlacementRules.NothingToPlace.At(default));
        }

        var map = placement.MapIn(drawing.Scale, box);
        return MappedDrawing.Try(drawing, Joined(map, back), out var placed) ? (placed with { Placement = placement, PlacementMap = map }, null) : (null, PlacementRules.OutOfRange.At(default));
    }

    private static Transform2D Joined(Transform2D map, Transform2D back) => back == Transform2D.Identity ? map : map.After(back);

    /// <summary>Box of the curves on the layers that are cut, without texts, whose letters may differ from plate to plate; millimetres.</summary>
    private static Bounds2D CutBoundsOf(Drawing drawing, DrawingSettings settings)
    {
        var taken = StageOptions.SelectionOf(settings).Taken(drawing.Layers);
        return drawing.Scale.ToMillimetres(DrawingPick.BoundsOf(drawing, Enumerable.Range(0, drawing.Entities.Count).Where(index => !drawing.Entities[index].Hidden && taken[drawing.Entities[index].Layer])));
    }
}
