using System.Text.RegularExpressions;

namespace Engraver.Workbench.Machines;

/// <summary>Groups of states, and their displayed and contract names.</summary>
public static partial class MachineStates
{
    /// <summary>True during a job of this program, also during a feed hold.</summary>
    public static bool IsJob(this MachineState state) => state is MachineState.Running or MachineState.DryRun or MachineState.Holding or MachineState.Held or MachineState.Stopping;

    /// <summary>True while the machine moves, or may move without another command. False for a held job.</summary>
    public static bool IsMotion(this MachineState state) => state is not MachineState.Held && (state.IsJob() || state is MachineState.Moving or MachineState.Busy);

    /// <summary>True if the machine is stopped without a fault, so that the next job may be armed.</summary>
    public static bool IsReady(this MachineState state) => state is MachineState.Ready or MachineState.Armed or MachineState.Stopped or MachineState.Complete or MachineState.Deviated;

    /// <summary>The displayed name, upper case.</summary>
    public static string DisplayText(this MachineState state) => Wording.Get("State." + state);

    /// <summary>The name in the runner's contract, the same in every language.</summary>
    public static string Token(this MachineState state) => state switch
    {
        MachineState.EmergencyStopOpen => "E-STOP OPEN",
        MachineState.Complete => "DONE",
        _ => InnerCapital().Replace(state.ToString(), " $0").ToUpperInvariant(),
    };

    [GeneratedRegex("(?<=.)[A-Z]")]
    private static partial Regex InnerCapital();
}
