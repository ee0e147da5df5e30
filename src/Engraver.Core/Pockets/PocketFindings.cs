using Engraver.Core.Diagnostics;

namespace Engraver.Core.Pockets;

/// <summary>The findings of the passes of a pocket.</summary>
public static class PocketFindings
{
    public static IEnumerable<Diagnostic> Of(PocketResult result, PocketOptions options)
    {
        ArgumentNullException.ThrowIfNull(result);
        ArgumentNullException.ThrowIfNull(options);
        if (result.Regions == 0) yield return PocketRules.NoInside.At(default);
        else if (result.WithoutInside > 0) yield return PocketRules.WithoutInside.At(default, FactText.Of(result.WithoutInside));
        if (result.Unresolved is [var open, ..]) yield return PocketRules.NotClosed.At(default, FactText.Of(open.X), FactText.Of(open.Y), FactText.Of(result.Unresolved.Count)) with { Place = open };
        if (result.LeftStanding is [var left, ..]) yield return PocketRules.LeftStanding.At(default, FactText.Of(result.UncoveredArea), FactText.Of(left.X), FactText.Of(left.Y)) with { Place = left };
        if (result.TooNarrow is [var narrow, ..]) yield return PocketRules.TooNarrow.At(default, FactText.Of(result.TooNarrow.Count), FactText.Of(narrow.Width), FactText.Of(narrow.Place.X), FactText.Of(narrow.Place.Y), FactText.Of(2.0 * options.ToolRadius)) with { Place = narrow.Place };
        if (result.Unreached.MaxBy(place => place.Depth) is { } deepest) yield return PocketRules.NotReached.At(default, FactText.Of(result.Unreached.Count), FactText.Of(result.Unreached.Sum(place => place.Area ?? 0.0)), FactText.Of(deepest.Depth), FactText.Of(deepest.Place.X), FactText.Of(deepest.Place.Y)) with { Place = deepest.Place };
    }
}
