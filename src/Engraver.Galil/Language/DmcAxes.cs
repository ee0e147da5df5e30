using Engraver.Core.Machines;

namespace Engraver.Galil.Language;

/// <summary>The controller's letters of its axes (galil-dmc.md B.1). Which of them a job moves is the profile's business (<see cref="MachineAxes"/>).</summary>
internal static class DmcAxes
{
    /// <summary>Every letter there is; a controller of four axes has the first four.</summary>
    public const string All = "ABCDEFGH";

    /// <summary>Whether the fields of a list from axis A on are those of the job's axes, as LI has them (galil-dmc.md B.1: <c>LI a,b,c,d</c>); VP has them in the order of VM.</summary>
    public static bool AreFirst(MachineAxes axes) => All.StartsWith(axes.Letters, StringComparison.Ordinal);

    /// <summary>An operand of each axis, divided by commas: <c>_RPA,_RPB</c>.</summary>
    /// <param name="operand">Without its letter.</param>
    public static string Operands(string letters, string operand) => string.Join(',', letters.Select(letter => operand + letter));
}
