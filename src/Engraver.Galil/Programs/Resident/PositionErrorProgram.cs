using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Resident;

/// <summary>#POSERR of the resident programs: an axis that is further from where it should be than ER allows ends the job (galil-dmc.md C.3, ER).</summary>
/// <remarks>Without it a jammed axis would be cut for to the end: what the host polls is the reference position, and a controller with OE 0 leaves the motors on.</remarks>
internal static class PositionErrorProgram
{
    /// <summary>Value of the error code then; TC codes are positive.</summary>
    public const int Code = -2;

    /// <summary>To stand ahead of <see cref="CommandErrorProgram"/>, whose #HALT it ends in.</summary>
    public static IReadOnlyList<string> Lines(MachineProfile profile) =>
    [
        "#POSERR",
        Subprograms.StopEverything(profile),
        Subprograms.Text($"{ResidentProgram.Variables.ErrorCode}={Code}"),
        "ZS",
        "JP#HALT",
    ];
}
