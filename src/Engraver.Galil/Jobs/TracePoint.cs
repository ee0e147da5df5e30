namespace Engraver.Galil.Jobs;

/// <summary>A polled position.</summary>
/// <param name="Seconds">Controller time since the job began.</param>
/// <param name="X">Counts, job frame.</param>
/// <param name="ToolOn">Whether the tool output was on, as the controller said.</param>
public readonly record struct TracePoint(double Seconds, int X, int Y, bool ToolOn)
{
    /// <summary>Segments that were known to be done before this poll: the tool is on the next of them, or further.</summary>
    public int Executed { get; init; }
}
