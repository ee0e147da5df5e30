namespace Engraver.Workbench.Machines.Alarms;

/// <summary>The alarm states of ISA-18.2. Acknowledging resets nothing.</summary>
public enum AlarmState
{
    Unacknowledged,

    Acknowledged,

    /// <summary>The cause is cleared but the alarm is not acknowledged: it stays in the list.</summary>
    ClearedUnacknowledged,

    /// <summary>The cause is cleared and the alarm was acknowledged.</summary>
    Cleared,
}
