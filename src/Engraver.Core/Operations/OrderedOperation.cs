using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;

namespace Engraver.Core.Operations;

/// <summary>The strokes of one operation in the order of cutting, in plan: one pass.</summary>
/// <param name="Shape">What was ordered.</param>
/// <param name="Path">Rows in order and direction, at height 0.</param>
/// <param name="Strokes">Consecutive rows of <paramref name="Path"/>.</param>
public sealed record OrderedOperation(ShapedOperation Shape, EntityTable Path, IReadOnlyList<OrderedStroke> Strokes)
{
    /// <summary>Rows that run against their drawn direction.</summary>
    public int Reversed { get; init; }

    public int DuplicatesRemoved { get; init; }

    /// <summary>Findings of joining and ordering.</summary>
    public IReadOnlyList<Diagnostic> Diagnostics { get; init; } = [];
}

/// <summary>One stroke of an operation.</summary>
/// <param name="FirstRow">Its first row.</param>
/// <param name="Rows">Number of its rows, at least 1.</param>
/// <param name="Closed">True when it ends where it starts.</param>
/// <param name="Inside">Index of the stroke of the same operation that directly encloses it, -1 for none.</param>
public readonly record struct OrderedStroke(int FirstRow, int Rows, bool Closed, int Inside);
