using System.Text.RegularExpressions;

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

    /// <summary>The profile says how the machine is homed, and it was not since power-on.</summary>
    NotHomed,

    /// <summary>The place of the drawing's zero is unknown.</summary>
    NoOrigin,

    /// <summary>The machine stands and a job may be armed.</summary>
    Ready,

    /// <summary>Everything was checked: START works.</summary>
    Armed,

    /// <summary>A job of this program runs and cuts.</summary>
    Running,

    /// <summary>A job of this program runs with the tool off.</summary>
    DryRun,

    /// <summary>A hold was asked for and the machine is still braking.</summary>
    Holding,

    /// <summary>A job is held: the machine stands on its path, tool off or up, and can resume.</summary>
    Held,

    /// <summary>A stop was asked for and the machine is still braking.</summary>
    Stopping,

    /// <summary>The last job ended before its end; the machine stands.</summary>
    Stopped,

    /// <summary>DONE: the last job went to its end; the machine stands.</summary>
    Complete,

    /// <summary>The last job went to its end and did not cut what is drawn; the machine stands.</summary>
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

/// <summary>Groups of states, and their names for people and for programs.</summary>
public static partial class MachineStates
{
    /// <summary>True while a job of this program is under way, also while it is held.</summary>
    public static bool IsJob(this MachineState state) => state is MachineState.Running or MachineState.DryRun or MachineState.Holding or MachineState.Held or MachineState.Stopping;

    /// <summary>True while something moves, or may move without another command. False for a held job.</summary>
    public static bool IsMotion(this MachineState state) => state is not MachineState.Held && (state.IsJob() || state is MachineState.Moving or MachineState.Busy);

    /// <summary>True when the machine stands without a fault, so that the next job may be armed.</summary>
    public static bool IsReady(this MachineState state) => state is MachineState.Ready or MachineState.Armed or MachineState.Stopped or MachineState.Complete or MachineState.Deviated;

    /// <summary>The name for people, upper case.</summary>
    public static string Said(this MachineState state) => Wording.Get("State." + state);

    /// <summary>The name in the runner's contract, the same in every language.</summary>
    public static string Word(this MachineState state) => state switch
    {
        MachineState.EmergencyStopOpen => "E-STOP OPEN",
        MachineState.Complete => "DONE",
        _ => InnerCapital().Replace(state.ToString(), " $0").ToUpperInvariant(),
    };

    [GeneratedRegex("(?<=.)[A-Z]")]
    private static partial Regex InnerCapital();
}
