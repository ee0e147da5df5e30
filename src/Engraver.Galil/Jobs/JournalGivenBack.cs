namespace Engraver.Galil.Jobs;

/// <summary>A later run has given the controller back in the name of the one that died.</summary>
/// <param name="By">Journal of the later run.</param>
public sealed record JournalGivenBack(string By)
{
    public string Kind { get; } = "givenBack";
}
