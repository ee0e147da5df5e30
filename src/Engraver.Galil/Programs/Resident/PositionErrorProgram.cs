using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Resident;

/// <summary>#POSERR of the resident programs: an axis whose position error exceeds ER ends the job (galil-dmc.md C.3, ER).</summary>
/// <remarks>Without it the job would continue with a jammed axis: the host polls the reference position, and a controller with OE 0 keeps the motors
/// on.</remarks>
internal static class PositionErrorProgram
{
    /// <summary>Value of the error code in that case; TC codes are positive.</summary>
    public const int Code = -2;

    /// <summary>Must come before <see cref="CommandErrorProgram"/>, because it ends in that program's #HALT.</summary>
    public static IReadOnlyList<string> Lines(MachineProfile profile) =>
    [
        "#POSERR",
        Subprograms.StopEverything(profile),
        .. RestOff(profile),
        DmcFormat.Text($"{ResidentProgram.Variables.ErrorCode}={Code}"),
        "ZS",
        "JP#HALT",
    ];

    /// <summary>The tool is not raised, because the positions of the axes are unknown; therefore the spindle must not turn either.</summary>
    private static IReadOnlyList<string> RestOff(MachineProfile profile) => profile.Height is not null && Subprograms.RestOff(profile) is { Length: > 0 } off ? [off] : [];
}
