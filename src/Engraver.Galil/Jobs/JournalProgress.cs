namespace Engraver.Galil.Jobs;

/// <summary>A sequence that is done, or how far a long one is.</summary>
/// <param name="Sequence">Place of the sequence in its stroke.</param>
/// <param name="Entity">Drawing entity of the last executed segment, -1 before the first.</param>
/// <param name="SegmentsExecuted">Since the job began, as the controller counted.</param>
/// <param name="X">_RPA.</param>
/// <param name="Time">Controller seconds since the job began.</param>
public sealed record JournalProgress(int Stroke, int Sequence, int Entity, int SegmentsExecuted, int X, int Y, double Time)
{
    public string Kind { get; } = "progress";
}
