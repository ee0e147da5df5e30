namespace Engraver.Workbench.Machines;

/// <summary>What the machine is doing, as far as the controller can say.</summary>
public enum MachineState
{
    /// <summary>No controller is connected.</summary>
    Offline,

    /// <summary>The link stands; the controller has not told its state yet.</summary>
    Connected,

    /// <summary>The motor of an axis that is needed is off.</summary>
    MotorsOff,

    /// <summary>It stands and a job may be armed.</summary>
    Ready,

    /// <summary>Everything was checked: START works.</summary>
    Armed,

    /// <summary>A job of ours runs.</summary>
    Running,

    /// <summary>A stop was asked for and the machine is still braking.</summary>
    Stopping,

    /// <summary>Something moves or a program runs that is not ours.</summary>
    Busy,

    /// <summary>A limit, an abort or a lost link stands in the way.</summary>
    Fault,

    /// <summary>The controller's abort input, the end of the emergency-stop chain where that is wired to it, is active.</summary>
    EmergencyStopOpen,
}
