namespace Engraver.Workbench.Machines;

/// <summary>State of the machine as reported by the controller.</summary>
public enum MachineState
{
    /// <summary>No controller is connected.</summary>
    Offline,

    /// <summary>Connected; the controller has not reported its state yet.</summary>
    Connected,

    /// <summary>The motor of a required axis is off.</summary>
    MotorsOff,

    /// <summary>The profile configures homing, and the machine was not homed since power-on.</summary>
    NotHomed,

    /// <summary>The position of the drawing's zero is unknown.</summary>
    NoOrigin,

    /// <summary>The machine is stopped and a job may be armed.</summary>
    Ready,

    /// <summary>All checks passed: START is enabled.</summary>
    Armed,

    /// <summary>A job of this program runs and cuts.</summary>
    Running,

    /// <summary>A job of this program runs with the tool off.</summary>
    DryRun,

    /// <summary>A feed hold was requested and the machine is decelerating.</summary>
    Holding,

    /// <summary>A job is held: the machine is stopped on its path, tool off or raised, and can resume.</summary>
    Held,

    /// <summary>A stop was requested and the machine is decelerating.</summary>
    Stopping,

    /// <summary>The last job ended early; the machine is stopped.</summary>
    Stopped,

    /// <summary>DONE: the last job completed; the machine is stopped.</summary>
    Complete,

    /// <summary>The last job completed but the cut differs from the drawing; the machine is stopped.</summary>
    Deviated,

    /// <summary>The operator moves the machine: a jog, a move to a position, homing, a frame run.</summary>
    Moving,

    /// <summary>An axis moves or a program runs that this program did not start.</summary>
    Busy,

    /// <summary>A limit, an abort or a lost link prevents a start.</summary>
    Fault,

    /// <summary>The controller's abort input, the end of the emergency-stop chain where that is wired to it, is active.</summary>
    EmergencyStopOpen,
}
