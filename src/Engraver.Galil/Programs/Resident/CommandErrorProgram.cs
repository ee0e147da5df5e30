using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Resident;

/// <summary>#CMDERR of the resident programs: without it one refused line stops every thread, the watchdog too (galil-dmc.md J.15).</summary>
/// <remarks>After a return thread 0 would continue after the refused line, so the handler does not return: it clears the stack and loops in #HALT until the
/// host halts the thread.</remarks>
public static class CommandErrorProgram
{
    /// <summary>A loop that does nothing, for a thread that must live so that #POSERR and #CMDERR run (galil-dmc.md C.3).</summary>
    internal const string Halted = "#HALT";

    /// <summary>Must run at the start of thread 0.</summary>
    internal const string ClearStatement = $"{ResidentProgram.Variables.ErrorCode}=0;{ResidentProgram.Variables.ErrorLine}=0";

    public static string Text(MachineProfile profile) => string.Join('\n', Lines(profile)) + "\n";

    internal static IReadOnlyList<string> Lines(MachineProfile profile) =>
    [
        Subprograms.CommandError,
        Subprograms.StopEverything(profile),
        .. SpindleOff(profile),
        $"{ResidentProgram.Variables.ErrorLine}=_ED;{ResidentProgram.Variables.ErrorCode}=_TC",
        $"MG \"CMDERR\",{ResidentProgram.Variables.ErrorLine},{ResidentProgram.Variables.ErrorCode}",
        "ZS",
        Halted,
        "WT 10",
        "JP#HALT",
        "EN",
    ];

    /// <summary>While the host lives it raises the tool and then switches the spindle off; behind a trip of the watchdog it was the raising that was
    /// refused, and nobody else is there.</summary>
    private static IReadOnlyList<string> SpindleOff(MachineProfile profile) =>
        profile is { Height: not null, Spindle: not null } ? [$"IF ({ResidentProgram.Variables.WatchdogTripped}<>0)", Subprograms.SpindleOff(profile), "ENDIF"] : [];
}
