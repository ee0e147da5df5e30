using Engraver.Core.Diagnostics;

namespace Engraver.Galil.Programs.Posting;

/// <summary>A job as chunks that fit the controller's memory.</summary>
/// <param name="Chunks">In order of cutting.</param>
/// <param name="Diagnostics">Strokes that had to be divided to fit the memory.</param>
internal sealed record PackedJob(IReadOnlyList<ProgramChunk> Chunks, IReadOnlyList<Diagnostic> Diagnostics);
