using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Resident;
using static Engraver.Galil.Programs.Subprograms;

namespace Engraver.Galil.Programs.Posting;

/// <summary>The parts that a posted program needs to run without a host: a watchdog that needs no heartbeat, and handlers that switch the tool off, stop and
/// end the job in every case (galil-dmc.md C.3).</summary>
/// <remarks> The watchdog (thread 1) trips when the tool is on and nothing moves for the time of <see cref="StandstillLimit"/>: a job that waits indefinitely.
/// It counts no heartbeat, so that it is independent of a host, and it ends with the job. #TCPERR prints no message, because a message that is not received
/// would cause the next error. No handler returns to the interrupted line, because the program would continue from the wrong position. </remarks>
internal static class UnattendedProgram
{
    /// <summary>Starts the watchdog; after the assignment of all variables that it reads.</summary>
    public static string Start => WatchdogProgram.StartStatement;

    /// <summary>Ends the watchdog, before the job ends or in a handler.</summary>
    public static string End { get; } = DmcFormat.Text($"HX{ResidentProgram.WatchdogThread}");

    /// <summary>The watchdog and the handlers other than #CMDERR.</summary>
    /// <param name="wait">The longest wait that an operation states, seconds.</param>
    public static IReadOnlyList<string> Lines(MachineProfile profile, double wait)
    {
        var stop = StopEverything(profile);
        var spindle = profile.Height is null ? string.Empty : RestOff(profile);
        const string Still = ResidentProgram.Variables.StandstillTicks;
        return new ProgramLines()
            .Line("#WDOG").Line("#WLIVE").Line(WatchdogProgram.StorePosition(profile))
            .Line("#WLOOP").Line("WT 50").Line($"{Still}={Still}+1").Line($"JP#WLIVE,{WatchdogProgram.ActivityCondition(profile)}").Line(DmcFormat.Text($"JP#WLOOP,{Still}<{StandstillLimit.ControllerTicks(profile, wait)}"))
            .Line(stop, DmcFormat.Text($"HX{ResidentProgram.MainThread}")).Line(spindle).Line("MG \"STANDSTILL\"").Line("EN")
            .Line("#LIMSWI").Line(stop).Line(spindle).Line("MG \"LIMIT\"").Line("JP#QUIT")
            .Line("#POSERR").Line(stop).Line(spindle).Line("MG \"POSERR\"").Line("JP#QUIT")
            .Line("#TCPERR").Line(stop).Line(spindle).Line("#QUIT").Line(End).Line(DmcFormat.Text($"HX{ResidentProgram.MainThread}")).Line("EN")
            .Lines;
    }
}
