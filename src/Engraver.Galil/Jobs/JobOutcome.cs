namespace Engraver.Galil.Jobs;

public enum JobOutcome
{
    Complete,

    /// <summary>By the operator; the machine stands.</summary>
    Stopped,

    /// <summary>The controller refused a command, was busy, or ended a motion that it should have finished.</summary>
    Refused,

    /// <summary>What was cut is not the drawing, by what the controller or the simulator's record says: the path left the drawing, or part of it was never cut.</summary>
    Deviated,

    /// <summary>The link failed, or the watchdog in the controller did not hear from this program and stopped the machine.</summary>
    LinkLost,
}
