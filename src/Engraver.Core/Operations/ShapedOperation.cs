using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Kerf;

namespace Engraver.Core.Operations;

/// <summary>The path of one operation in plan: one pass, before it has depths.</summary>
/// <param name="Part">What it takes.</param>
/// <param name="Path">Rows of the path of the tool's centre, at height 0; every row has the entity as which it was drawn.</param>
/// <param name="Strokes">The strokes in <paramref name="Path"/>, by their number of rows, where their order and direction are part of the shape; null: the rows
/// are joined to contours and ordered.</param>
public sealed record ShapedOperation(OperationPart Part, EntityTable Path, IReadOnlyList<int>? Strokes)
{
    public Operation Operation => Part.Operation;

    /// <summary>Warnings and notes of the shape.</summary>
    public IReadOnlyList<Diagnostic> Findings { get; init; } = [];

    /// <summary>Why the shape cannot be machined.</summary>
    public IReadOnlyList<Diagnostic> Faults { get; init; } = [];

    /// <summary>What a profile does not reach.</summary>
    public IReadOnlyList<UncutPlace> Uncut { get; init; } = [];
}
