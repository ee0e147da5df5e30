using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.Composition;

/// <summary>What became of a posted program in a controller.</summary>
/// <param name="Diagnostics">Why the program did not run to its end; empty when it did.</param>
public sealed record ProgramReplay(IReadOnlyList<Diagnostic> Diagnostics);

/// <summary>How far a replay has come.</summary>
/// <param name="Chunk">From 1.</param>
/// <param name="Chunks">All of them.</param>
/// <param name="MachineTime">Controller time so far.</param>
/// <param name="Expected">Controller time that the whole is expected to take; zero when nothing is expected to move.</param>
public readonly record struct ReplayProgress(int Chunk, int Chunks, TimeSpan MachineTime, TimeSpan Expected)
{
    /// <summary>0 to 1, never less than before: by the programs that are done, and by the time, whichever is more.</summary>
    public double Fraction => Math.Max((Chunk - 1.0) / Chunks, Expected > TimeSpan.Zero ? Math.Min(1.0, MachineTime / Expected) : 0.0);
}
