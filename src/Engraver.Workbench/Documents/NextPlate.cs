using Engraver.Core.Diagnostics;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.Documents;

/// <summary>The plate that is engraved next.</summary>
/// <param name="Plate">Null if there is none, or no values.</param>
/// <param name="Fields">The fields in the texts that are cut; null without fields.</param>
/// <param name="Problem">Why it has no values; null if it has.</param>
/// <param name="Refusal">A plate with its counters that was not finished, about which must be decided first; null for none.</param>
public sealed record NextPlate(Plate? Plate, PlateFields? Fields, Diagnostic? Problem, Diagnostic? Refusal)
{
    /// <summary>The drawing has no plates.</summary>
    public static NextPlate None { get; } = new(null, null, null, null);
}
