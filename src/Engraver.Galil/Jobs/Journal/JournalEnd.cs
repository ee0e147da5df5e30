using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>Last line of a job in the journal; a job without it did not end properly.</summary>
/// <param name="LeftAsFound">Program, settings and motors of the controller are restored; otherwise the next run restores them.</param>
public sealed record JournalEnd(JobOutcome Outcome, string Sentence, int SegmentsExecuted, long? X, long? Y, double Time, bool LeftAsFound)
{
    public string Kind { get; } = "end";

    /// <summary>Segments that were certainly cut as a whole.</summary>
    public int Cut { get; init; }

    /// <summary>Counts along the next one that were cut too.</summary>
    public double Along { get; init; }
}
