using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.Verification;

/// <summary>What became of a posted program in a controller.</summary>
/// <param name="Diagnostics">Why the program did not run to its end; empty when it did.</param>
public sealed record ProgramReplay(IReadOnlyList<Diagnostic> Diagnostics);

/// <summary>How far a replay has come.</summary>
/// <param name="Chunk">From 1.</param>
/// <param name="Chunks">All of them.</param>
/// <param name="MachineTime">Controller time so far.</param>
public readonly record struct ReplayProgress(int Chunk, int Chunks, TimeSpan MachineTime);
