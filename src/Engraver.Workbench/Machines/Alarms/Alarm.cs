namespace Engraver.Workbench.Machines.Alarms;

/// <summary>Something that the operator must know and see to. Immutable; the log replaces it as it changes.</summary>
/// <param name="Number">1 is the first since the program began.</param>
/// <param name="Time">When it was first raised.</param>
/// <param name="Cause">Alarms of the same cause and the same <paramref name="Where"/> are counted as one.</param>
/// <param name="What">One sentence.</param>
/// <param name="Where">The link, the axis, the place of the job.</param>
/// <param name="ToDo">What the operator can do about it, one sentence.</param>
public sealed record Alarm(int Number, DateTimeOffset Time, AlarmCause Cause, string What, string Where, string ToDo)
{
    public AlarmState State { get; init; }

    /// <summary>How often it was raised.</summary>
    public int Count { get; init; } = 1;

    /// <summary>When it was raised last.</summary>
    public DateTimeOffset LastTime { get; init; } = Time;

    /// <summary>True for the one that came first while no other stood: the likely cause of those after it.</summary>
    public bool IsFirstOut { get; init; }

    /// <summary>True while the cause stands.</summary>
    public bool IsActive => State is AlarmState.Unacknowledged or AlarmState.Acknowledged;

    public bool NeedsAcknowledging => State is AlarmState.Unacknowledged or AlarmState.ClearedUnacknowledged;
}
