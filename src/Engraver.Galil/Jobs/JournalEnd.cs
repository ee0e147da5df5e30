namespace Engraver.Galil.Jobs;

/// <summary>Last line of a job in the journal; a job without it died.</summary>
public sealed record JournalEnd(JobOutcome Outcome, string Sentence, int SegmentsExecuted, int? X, int? Y, double Time)
{
    public string Kind { get; } = "end";
}
