using Engraver.Core.Diagnostics;

namespace Engraver.Galil.Programs;

/// <summary>What came of a toolpath.</summary>
/// <param name="Program">Null when something cannot be cut at all; the errors among <paramref name="Diagnostics"/> say what.</param>
/// <param name="Diagnostics">Errors, warnings and notes, in the order of the strokes.</param>
public sealed record MotionGeneration(MotionProgram? Program, IReadOnlyList<Diagnostic> Diagnostics);
