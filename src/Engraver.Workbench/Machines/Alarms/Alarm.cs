namespace Engraver.Workbench.Machines.Alarms;

/// <summary>An alarm for the operator. Immutable; the log replaces it when it changes.</summary>
/// <param name="Number">1 is the first since the program start.</param>
/// <param name="Time">Time of the first occurrence.</param>
/// <param name="Cause">Alarms with the same cause and the same <paramref name="Where"/> are counted as one.</param>
/// <param name="What">One sentence.</param>
/// <param name="Where">The link, the axis or the position in the job.</param>
/// <param name="ToDo">The remedy, one sentence.</param>
public sealed record Alarm(int Number, DateTimeOffset Time, AlarmCause Cause, string What, string Where, string ToDo)
{
    public AlarmState State { get; init; }

    /// <summary>Number of occurrences.</summary>
    public int Count { get; init; } = 1;

    /// <summary>Time of the last occurrence.</summary>
    public DateTimeOffset LastTime { get; init; } = Time;

    /// <summary>True for the first alarm while no other was active: the likely cause of the following ones.</summary>
    public bool IsFirstOut { get; init; }

    /// <summary>True while the cause is active.</summary>
    public bool IsActive => State is AlarmState.Unacknowledged or AlarmState.Acknowledged;

    public bool NeedsAcknowledging => State is AlarmState.Unacknowledged or AlarmState.ClearedUnacknowledged;
}
