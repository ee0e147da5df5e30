using Engraver.Core.Drawings;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>A placement in words.</summary>
public static class PlacementText
{
    /// <summary>What differs from the file, in the order in which it is applied, separated by commas.</summary>
    public static string Of(DrawingPlacement placement)
    {
        ArgumentNullException.ThrowIfNull(placement);
        return placement.IsNone ? Wording.Get("Placement.None") : string.Join(", ", Parts(placement));
    }

    private static IEnumerable<string> Parts(DrawingPlacement placement)
    {
        if (placement.Scale != 1.0) yield return Wording.Get("Placement.Scaled", NumberPrompt.Format(placement.Scale));
        if (placement.Mirror != MirrorAxis.None) yield return Wording.Get("Placement.Mirrored", placement.Mirror);
        if (placement.Rotation.Degrees != 0.0) yield return Wording.Get("Placement.Rotated", NumberPrompt.Format(placement.Rotation.Degrees));
        if (placement.Place != BlankPlace.None) yield return Wording.Get("Placement." + placement.Place);
        if (placement is { Align: { } from, To: { } to }) yield return Wording.Get("Placement.Aligned", PointSetting.Exact(from.First), PointSetting.Exact(from.Second), PointSetting.Exact(to.First), PointSetting.Exact(to.Second));
        if (placement.Move != default) yield return Wording.Get("Placement.Moved", NumberPrompt.Format(placement.Move.X), NumberPrompt.Format(placement.Move.Y));
        if (placement.Blank != default) yield return Wording.Get("Placement.OnBlank", NumberPrompt.Format(placement.Blank.X), NumberPrompt.Format(placement.Blank.Y));
        if (placement.Back != MirrorAxis.None) yield return Wording.Get("Placement.Turned", placement.Back);
    }
}
