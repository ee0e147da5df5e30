using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Resident;
using static Engraver.Galil.Programs.Subprograms;

namespace Engraver.Galil.Programs.Posting;

/// <summary>What a posted program needs to run from the controller's memory with nobody connected: a watchdog that knows of no host, and handlers that
/// switch the tool off, stop and end the job whatever happens (galil-dmc.md C.3).</summary>
/// <remarks>
/// The watchdog (thread 1) trips when the tool works and nothing moves for the time of <see cref="StandstillLimit"/>: a job that waits for ever. It counts
/// no heartbeat, so the silence of a host is nothing to it, and it ends with the job.
/// #TCPERR says nothing: a message that nobody takes would be the next error. None of the handlers goes back to where it came from, for the program would
/// go on from the wrong place.
/// </remarks>
internal static class UnattendedProgram
{
    /// <summary>Starts the watchdog; behind everything that it reads.</summary>
    public static string Start => WatchdogProgram.StartStatement;

    /// <summary>Ends the watchdog, before the job ends or in a handler.</summary>
    public static string End { get; } = Text($"HX{ResidentProgram.WatchdogThread}");

    /// <summary>The watchdog and the handlers beside #CMDERR.</summary>
    public static IReadOnlyList<string> Lines(MachineProfile profile)
    {
        var stop = StopEverything(profile);
        var spindle = profile.Height is null ? string.Empty : SpindleOff(profile);
        const string Still = ResidentProgram.Variables.Still;
        return new ProgramLines()
            .Line("#WDOG").Line("#WLIVE").Line(WatchdogProgram.Keep(profile))
            .Line("#WLOOP").Line("WT 50").Line($"{Still}={Still}+1").Line($"JP#WLIVE,{WatchdogProgram.Lives(profile)}").Line(Text($"JP#WLOOP,{Still}<{StandstillLimit.ControllerTicks(profile)}"))
            .Line(stop, Text($"HX{ResidentProgram.MainThread}")).Line(spindle).Line("MG \"STANDSTILL\"").Line("EN")
            .Line("#LIMSWI").Line(stop).Line(spindle).Line("MG \"LIMIT\"").Line("JP#QUIT")
            .Line("#POSERR").Line(stop).Line(spindle).Line("MG \"POSERR\"").Line("JP#QUIT")
            .Line("#TCPERR").Line(stop).Line(spindle).Line("#QUIT").Line(End).Line(Text($"HX{ResidentProgram.MainThread}")).Line("EN")
            .Lines;
    }
}
