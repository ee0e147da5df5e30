namespace Engraver.Workbench.Sending;

public enum SendOutcome : byte
{
    Complete,

    /// <summary>Stopped by the operator.</summary>
    Stopped,

    LinkLost,

    /// <summary>The other side sent XOFF and no XON in time.</summary>
    PausedTooLong,
}
