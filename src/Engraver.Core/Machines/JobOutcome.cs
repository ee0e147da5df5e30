namespace Engraver.Core.Machines;

public enum JobOutcome
{
    Complete,

    /// <summary>The strokes of one tool are complete, and the rest needs another one; the machine is at rest.</summary>
    ToolChange,

    /// <summary>The strokes before a stop between repeats are complete, and the rest is cut with the same tool; the machine is at rest.</summary>
    OperatorStop,

    /// <summary>Stopped by the operator; the machine is at rest.</summary>
    Stopped,

    /// <summary>The controller refused a command, was busy, or ended a motion that it should have finished.</summary>
    Refused,

    /// <summary>By the controller's positions or the simulator's record, the path left the drawing, or part of the drawing was not cut.</summary>
    Deviated,

    /// <summary>The link failed, or the watchdog in the controller received nothing from this program and stopped the machine.</summary>
    LinkLost,
}
