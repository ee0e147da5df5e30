namespace Engraver.Galil.Jobs.Journal;

/// <summary>The journal could no longer be written while its job continued: how far the job was cut is not known, and it cannot be resumed.</summary>
public sealed record JournalGivenUp(string Reason)
{
    public string Kind { get; } = "givenUp";
}
