using Engraver.Core.EntityTables;

namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>A table with recovered arcs.</summary>
/// <param name="Table">Fewer rows, the same path within the error.</param>
/// <param name="Arcs">One for each arc, in row order.</param>
public sealed record ArcRecoveryResult(EntityTable Table, IReadOnlyList<ArcRecoveryNote> Arcs);
