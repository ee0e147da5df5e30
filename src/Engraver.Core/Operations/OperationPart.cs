using Engraver.Core.EntityTables;

namespace Engraver.Core.Operations;

/// <summary>What one operation takes.</summary>
/// <param name="Operation">An operation that is run.</param>
/// <param name="Tool">Its tool.</param>
/// <param name="Table">The rows of the drawing that it takes, analysed, in file order; may be empty.</param>
public sealed record OperationPart(Operation Operation, CuttingTool Tool, EntityTable Table);
