using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;

namespace Engraver.Core.Kerf;

/// <summary>A job compensated for the radius of its tool.</summary>
/// <param name="Table">The analysed table of the path of the tool's centre; every row has the entity as which it was drawn.</param>
/// <param name="Uncut">Material that the tool does not reach, largest first.</param>
/// <param name="HasOpenContours">Open contours are cut on their line.</param>
/// <param name="Diagnostics">Findings, of rules KRF0001 to KRF0007.</param>
public sealed record KerfResult(EntityTable Table, IReadOnlyList<UncutPlace> Uncut, bool HasOpenContours, IReadOnlyList<Diagnostic> Diagnostics);
