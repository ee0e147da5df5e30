using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Resident;

/// <summary>#CMDERR of the resident programs: without it one refused line stops every thread, including the watchdog (galil-dmc.md J.15).</summary>
/// <remarks>After a return thread 0 would continue after the refused line, so the handler does not return: it clears the stack and loops in #HALT until the
/// host halts the thread.</remarks>
public static class CommandErrorProgram
{
    /// <summary>A loop without effect, for a thread that must run so that #POSERR and #CMDERR can run (galil-dmc.md C.3).</summary>
    internal const string Halted = "#HALT";

    /// <summary>Must run at the start of thread 0.</summary>
    internal const string ClearStatement = $"{ResidentProgram.Variables.ErrorCode}=0;{ResidentProgram.Variables.ErrorLine}=0";

    public static string Text(MachineProfile profile) => string.Join('\n', Lines(profile)) + "\n";

    internal static IReadOnlyList<string> Lines(MachineProfile profile) =>
    [
        Subprograms.CommandError,
        Subprograms.StopEverything(profile),
        .. RestOff(profile),
        $"{ResidentProgram.Variables.ErrorLine}=_ED;{ResidentProgram.Variables.ErrorCode}=_TC",
        $"MG \"CMDERR\",{ResidentProgram.Variables.ErrorLine},{ResidentProgram.Variables.ErrorCode}",
        "ZS",
        Halted,
        "WT 10",
        "JP#HALT",
        "EN",
    ];

    /// <summary>While the host is connected, it raises the tool and then switches the spindle off. After a trip of the watchdog the refused line was the one
    /// that raises the tool, and no host is connected.</summary>
    private static IReadOnlyList<string> RestOff(MachineProfile profile) =>
        profile.Height is not null && Subprograms.RestOff(profile) is { Length: > 0 } off ? [$"IF ({ResidentProgram.Variables.WatchdogTripped}<>0)", off, "ENDIF"] : [];
}
