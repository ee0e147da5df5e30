using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Resident;

/// <summary>#CMDERR of the resident programs: without it one refused line stops every thread, the watchdog too (galil-dmc.md J.15).</summary>
/// <remarks>After a return thread 0 would continue after the refused line, so the handler does not return: it clears the stack and loops in #HALT until the host halts the thread.</remarks>
public static class CommandErrorProgram
{
    /// <summary>Must run at the start of thread 0.</summary>
    internal const string ClearStatement = $"{ResidentProgram.Variables.ErrorCode}=0;{ResidentProgram.Variables.ErrorLine}=0";

    public static string Text(MachineProfile profile) => string.Join('\n', Lines(profile)) + "\n";

    internal static IReadOnlyList<string> Lines(MachineProfile profile) =>
    [
        Subprograms.CommandError,
        Subprograms.StopEverything(profile),
        $"{ResidentProgram.Variables.ErrorLine}=_ED;{ResidentProgram.Variables.ErrorCode}=_TC",
        $"MG \"CMDERR\",{ResidentProgram.Variables.ErrorLine},{ResidentProgram.Variables.ErrorCode}",
        "ZS",
        "#HALT",
        "WT 10",
        "JP#HALT",
        "EN",
    ];
}
