namespace Engraver.Core.Machines;

/// <summary>The hold state of a running job.</summary>
public enum JobPhase : byte
{
    Running,

    /// <summary>A hold was requested; the machine still moves, or the tool is still on.</summary>
    Holding,

    /// <summary>At standstill with the tool off or raised, waiting for the operator, who may move the machine by hand.</summary>
    Held,

    /// <summary>The machine returns to its path, and the tool is switched on or lowered again.</summary>
    Resuming,
}
