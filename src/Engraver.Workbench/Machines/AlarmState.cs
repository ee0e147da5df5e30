namespace Engraver.Workbench.Machines;

/// <summary>The states of ISA-18.2 that an alarm goes through. Acknowledging says "seen" and resets nothing.</summary>
public enum AlarmState
{
    Unacknowledged,

    Acknowledged,

    /// <summary>The cause is gone, nobody has said "seen" yet: it stays in the list.</summary>
    ClearedUnacknowledged,

    /// <summary>Gone and seen.</summary>
    Cleared,
}
