namespace Engraver.Galil.Jobs.Journal;

/// <summary>A later job has resumed this one, and has its own journal.</summary>
/// <param name="By">Path of that journal.</param>
public sealed record JournalResumed(string By)
{
    public string Kind { get; } = "resumed";
}
