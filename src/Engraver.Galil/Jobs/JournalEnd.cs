namespace Engraver.Galil.Jobs;

/// <summary>Last line of a job in the journal; a job without it died.</summary>
/// <param name="LeftAsFound">Program, settings and motors of the controller are again as they were found; otherwise the next run gives them back.</param>
public sealed record JournalEnd(JobOutcome Outcome, string Sentence, int SegmentsExecuted, int? X, int? Y, double Time, bool LeftAsFound)
{
    public string Kind { get; } = "end";
}
