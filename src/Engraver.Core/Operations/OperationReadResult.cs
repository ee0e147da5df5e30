using Engraver.Core.Diagnostics;

namespace Engraver.Core.Operations;

/// <summary>The result of reading an operations file.</summary>
/// <param name="Plan">Null when the file cannot be used.</param>
/// <param name="Diagnostics">What is wrong, with its line.</param>
public sealed record OperationReadResult(OperationPlan? Plan, IReadOnlyList<Diagnostic> Diagnostics);
