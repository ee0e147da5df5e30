namespace Engraver.Core.Machines;

/// <summary>The cause of an end with <see cref="JobOutcome.LinkLost"/>.</summary>
public enum LinkLoss
{
    /// <summary>The link failed, or the controller no longer replied.</summary>
    Link,

    /// <summary>The watchdog in the controller received nothing from this program in time and stopped the machine; the link may still work.</summary>
    Watchdog,
}
