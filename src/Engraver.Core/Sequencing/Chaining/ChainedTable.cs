using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>The result of chaining: the contours of a table, without duplicates, not yet in the order of cutting.</summary>
/// <param name="Analysed">The whole analysed table, duplicates included.</param>
/// <param name="Kept">The rows that are cut, including recovered arcs; contours refer to these.</param>
/// <param name="Segments">The kept rows as segments.</param>
/// <param name="Chain">Contours and open ends.</param>
/// <param name="Inside">The closed contour directly around each contour, -1 for none.</param>
/// <param name="Drawing">The drawing of the entity indices; null when the table was made without one.</param>
/// <param name="Diagnostics">Findings so far.</param>
public sealed record ChainedTable(
    EntityTable Analysed,
    EntityTable Kept,
    ReadOnlyMemory<Segment> Segments,
    ChainResult Chain,
    IReadOnlyList<int> Inside,
    Drawing? Drawing,
    IReadOnlyList<Diagnostic> Diagnostics)
{
    public int DuplicatesRemoved { get; init; }
}
