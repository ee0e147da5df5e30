namespace Engraver.Galil.Jobs;

/// <summary>Where a job is, from what the controller said last.</summary>
/// <param name="Stroke">Index of the stroke under way.</param>
/// <param name="X">Counts, job frame.</param>
/// <param name="Seconds">Controller time since the job began.</param>
public readonly record struct JobProgress(int Stroke, int SegmentsSent, int SegmentsExecuted, int SegmentCount, int X, int Y, bool ToolOn, double Seconds);
