namespace Engraver.Workbench.Machines.Alarms;

/// <summary>Causes by which alarms are grouped: the same cause raises one alarm with a count.</summary>
public enum AlarmCause
{
    /// <summary>The link was lost, idle or in a job.</summary>
    LinkLost,

    /// <summary>The controller refused a command.</summary>
    Refused,

    /// <summary>The watchdog in the controller stopped the machine.</summary>
    WatchdogTripped,

    /// <summary>A limit switch is active.</summary>
    Limit,

    /// <summary>An axis was switched off, or its following error is too large.</summary>
    FollowingError,

    /// <summary>The abort input is or was active.</summary>
    AbortInput,

    /// <summary>A job ended early.</summary>
    JobStopped,

    /// <summary>The cut differs from the drawing according to the reported positions.</summary>
    Deviated,

    /// <summary>An internal error; the machine was stopped.</summary>
    InternalError,

    /// <summary>The desktop lost its display; the machine was stopped.</summary>
    DisplayLost,
}
