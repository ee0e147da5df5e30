namespace Engraver.Galil.Jobs.Journal;

/// <summary>A later run has restored the controller after the one that failed.</summary>
/// <param name="By">Journal of the later run.</param>
public sealed record JournalGivenBack(string By)
{
    public string Kind { get; } = "givenBack";
}
