namespace Engraver.Galil.Jobs;

/// <summary>What a job that ended with <see cref="JobOutcome.LinkLost"/> was lost by.</summary>
public enum LinkLoss
{
    /// <summary>The link failed, or the controller fell silent.</summary>
    Link,

    /// <summary>The watchdog in the controller did not hear from this program in time and stopped the machine; the link may stand.</summary>
    Watchdog,
}
