namespace Engraver.Galil.Jobs;

/// <summary>A polled position.</summary>
/// <param name="Seconds">Controller time since the job began.</param>
/// <param name="X">Counts, job frame.</param>
/// <param name="ToolOn">Whether the tool output was on, as the controller said.</param>
public readonly record struct TracePoint(double Seconds, int X, int Y, bool ToolOn);
