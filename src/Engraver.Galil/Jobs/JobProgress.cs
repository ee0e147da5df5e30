namespace Engraver.Galil.Jobs;

/// <summary>Where a job is, from what the controller said last.</summary>
/// <param name="Stroke">Index of the stroke under way.</param>
/// <param name="X">Counts, job frame.</param>
/// <param name="Seconds">Controller time since the job began.</param>
/// <param name="Outputs">Outputs 1 to 8 (_OP0), bit 0 is output 1; null where nobody asked.</param>
public readonly record struct JobProgress(int Stroke, int SegmentsSent, int SegmentsExecuted, int SegmentCount, int X, int Y, bool ToolOn, double Seconds, int? Outputs = null);
