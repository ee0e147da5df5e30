using Engraver.Galil.Programs.Generation;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>A sequence, a call or a program is about to begin: what the controller counts from now on belongs to it.</summary>
/// <param name="First">Its first segment, in the order of cutting of the whole program.</param>
/// <param name="Starts">Segments before each of its sequences, and as the last number all of them.</param>
/// <param name="Calls">seq before it.</param>
public sealed record JournalOpened(int First, IReadOnlyList<int> Starts, int Calls)
{
    public string Kind { get; } = "opened";

    /// <summary>Segments that the controller counts after which the same segment of the program continues, in order; null for none.</summary>
    public IReadOnlyList<int>? Divided { get; init; }

    /// <summary>Segments of the program that are done when the controller has counted this many of its sequence.</summary>
    public int Done(int counted) => Math.Min(CutSequence.WholeAmong(Divided ?? [], counted), Starts[^1]);
}
