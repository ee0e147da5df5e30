using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Compares the motor types of the profile with those of the controller in a posted program, which ends with a message if one differs. A program
/// cannot set them, because MT needs the motor off, and the position of an axis may change while it is off (galil-dmc.md C, MT).</summary>
internal static class MotorTypeTest
{
    /// <summary>Run before the motors are switched on; empty for a profile without motor types.</summary>
    public static IReadOnlyList<string> Lines(MachineProfile profile) => [.. Typed(profile).Select(axis => $"JP{Label(axis)},_MT{axis.Letter}<>{Type(axis)}")];

    /// <summary>The targets of the jumps in these lines: nothing has been moved yet, and the tool is off.</summary>
    public static IReadOnlyList<string> Ends(MachineProfile profile)
    {
        var lines = new ProgramLines();
        foreach (var axis in Typed(profile)) lines.Line(Label(axis)).Line($"MG \"MT{axis.Letter} IS\",_MT{axis.Letter},\" NOT {Type(axis)}. SEND MO{axis.Letter} THEN MT{axis.Letter}={Type(axis)}\"").Line("EN");
        return lines.Lines;
    }

    private static IEnumerable<MachineAxis> Typed(MachineProfile profile) => profile.Axes.All.Where(axis => axis.MotorType is not null);

    private static string Label(MachineAxis axis) => $"#MTYPE{axis.Letter}";

    private static string Type(MachineAxis axis) => DmcFormat.Number(axis.MotorType!.Value);
}
