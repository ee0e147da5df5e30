using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Operations;

/// <summary>What one operation takes.</summary>
/// <param name="Operation">An operation that is run.</param>
/// <param name="Tool">Its tool.</param>
/// <param name="Table">The rows of the drawing that it machines, analysed, in file order; may be empty. The curves of blocks at whose insertion points it
/// drills are not among them.</param>
public sealed record OperationPart(Operation Operation, CuttingTool Tool, EntityTable Table)
{
    /// <summary>Points and insertion points at which it drills, in the order of the drawing.</summary>
    public IReadOnlyList<DrillPlace> Places { get; init; } = [];
}

/// <summary>A point or an insertion point at which an operation drills.</summary>
/// <param name="Place">In millimetres.</param>
/// <param name="EntityIndex">Its entity in the drawing of the job.</param>
public readonly record struct DrillPlace(Point2D Place, int EntityIndex);
