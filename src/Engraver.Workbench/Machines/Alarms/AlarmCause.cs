namespace Engraver.Workbench.Machines.Alarms;

/// <summary>What alarms are grouped by: the same cause raises one alarm with a count.</summary>
public enum AlarmCause
{
    /// <summary>The link was lost, idle or in a job.</summary>
    LinkLost,

    /// <summary>The controller refused a command.</summary>
    Refused,

    /// <summary>The watchdog in the controller stopped the machine.</summary>
    WatchdogTripped,

    /// <summary>A limit switch is hit.</summary>
    Limit,

    /// <summary>An axis was switched off or stands too far from its command.</summary>
    FollowingError,

    /// <summary>The abort input is or was active.</summary>
    AbortInput,

    /// <summary>A job ended before its end.</summary>
    JobStopped,

    /// <summary>A job cut something else than the drawing, judged by the positions that the controller told.</summary>
    Deviated,

    /// <summary>A bug in a command or in the program around it; the machine was stopped.</summary>
    InternalError,

    /// <summary>The display of the desktop is gone; the machine was stopped.</summary>
    DisplayLost,
}
