namespace Engraver.Workbench.Machines;

/// <summary>State of a feed hold.</summary>
internal enum FeedHoldPhase
{
    /// <summary>Not held.</summary>
    None,

    /// <summary>A hold was requested; the machine decelerates.</summary>
    Braking,

    /// <summary>The machine is stopped.</summary>
    Held,
}
