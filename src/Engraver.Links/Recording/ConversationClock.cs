namespace Engraver.Links.Recording;

/// <summary>The clock of the times of a recording.</summary>
public enum ConversationClock
{
    /// <summary>The wall clock of the host, from the start of the recording.</summary>
    Wall,

    /// <summary>The clock of a simulated controller that shares it, exact: time advanced through commands, and while the host waited.</summary>
    Controller,

    /// <summary>The clock of a simulated controller in real time, exact: commands took no time.</summary>
    RealTime,
}
