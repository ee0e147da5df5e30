namespace Engraver.Core.Machines;

/// <summary>A polled position.</summary>
/// <param name="Seconds">Controller time since the job began.</param>
/// <param name="Place">Counts, job frame.</param>
/// <param name="ToolOn">Whether the tool output was on, as the controller reported.</param>
public readonly record struct TracePoint(double Seconds, CountsPoint Place, bool ToolOn)
{
    public long X => Place.X;

    public long Y => Place.Y;

    /// <summary>Segments known to be done before this poll: the tool is on the next one, or further.</summary>
    public int Executed { get; init; }

    /// <summary>Distance of each motor from its command at the last reading, counts; null before the first reading, and where it is not read.</summary>
    public CountsPoint? Error { get; init; }
}
