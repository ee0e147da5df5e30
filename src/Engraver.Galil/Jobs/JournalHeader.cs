namespace Engraver.Galil.Jobs;

/// <summary>First line of a job in the journal.</summary>
/// <param name="StartX">_RPA when the job began.</param>
/// <param name="FrameX">Job frame: what was added to drawing counts to get the controller's.</param>
public sealed record JournalHeader(string Drawing, string Controller, JobMode Mode, int SegmentCount, int StartX, int StartY, int FrameX, int FrameY, DateTimeOffset StartedAt)
{
    public string Kind { get; } = "job";
}
