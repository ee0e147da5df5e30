using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines;

/// <summary>The result of motion generation.</summary>
/// <param name="Program">Null when something cannot be cut; the errors among <paramref name="Diagnostics"/> state what.</param>
/// <param name="Diagnostics">Errors, warnings and notes, in the order of the strokes.</param>
public sealed record MotionGeneration(MotionProgram? Program, IReadOnlyList<Diagnostic> Diagnostics);
