namespace Engraver.Galil.Jobs.Journal;

/// <summary>A sequence that is complete, or the progress of a long one.</summary>
/// <param name="Sequence">Index of the sequence in its stroke.</param>
/// <param name="Entity">Drawing entity of the last executed segment, -1 before the first.</param>
/// <param name="SegmentsExecuted">Since the job began, as the controller counted.</param>
/// <param name="X">_RPA.</param>
/// <param name="Time">Controller seconds since the job began.</param>
public sealed record JournalProgress(int Stroke, int Sequence, int Entity, int SegmentsExecuted, long X, long Y, double Time)
{
    public string Kind { get; } = "progress";

    /// <summary>Segments that are certainly cut as a whole.</summary>
    public int Cut { get; init; }

    /// <summary>Counts along the next one that are cut too.</summary>
    public double Along { get; init; }
}
