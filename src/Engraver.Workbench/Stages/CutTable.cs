using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Kerf;
using Engraver.Core.Sequencing;

namespace Engraver.Workbench.Stages;

/// <summary>The entities to cut.</summary>
/// <param name="Table">Analysed rows: as drawn, or the path of the tool centre.</param>
/// <param name="Kerf">The compensation; null without one.</param>
/// <param name="Diagnostics">Findings of chaining the drawing and of the compensation.</param>
public sealed record CutTable(EntityTable Table, KerfResult? Kerf, IReadOnlyList<Diagnostic> Diagnostics)
{
    /// <summary>The findings that the sequencing of the compensated table does not repeat.</summary>
    public IEnumerable<Diagnostic> FindingsBeside(SequencingResult sequence)
    {
        ArgumentNullException.ThrowIfNull(sequence);
        var repeated = sequence.Diagnostics.Select(finding => finding.Id).ToHashSet();
        return Diagnostics.Where(finding => !repeated.Contains(finding.Id));
    }
}
