using Engraver.Core.Diagnostics;

namespace Engraver.Galil.Programs;

/// <summary>A job as program text: one or more chunks, each complete with its subprograms, to be downloaded and run (XQ #JOB) one after the other without moving the machine in between.</summary>
/// <param name="Chunks">Each ends with a line end (LF); with more than one, each begins with a comment line "'CHUNK 2 OF 3".</param>
/// <param name="Diagnostics">Strokes that had to be cut to fit the memory.</param>
public sealed record DmcPostText(IReadOnlyList<string> Chunks, IReadOnlyList<Diagnostic> Diagnostics)
{
    public string Text => string.Concat(Chunks);
}
