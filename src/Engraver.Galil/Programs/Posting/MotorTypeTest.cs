using Engraver.Core.Machines;
using Engraver.Galil.Language;
using static Engraver.Galil.Programs.Subprograms;

namespace Engraver.Galil.Programs.Posting;

/// <summary>What a posted program does about the motor types of the profile: it compares them with those of the controller and ends with a message where
/// one differs. It cannot set them, because MT needs the motor off, and an axis may then count from another place (galil-dmc.md C, MT).</summary>
internal static class MotorTypeTest
{
    /// <summary>Before the motors are switched on; empty for a profile without motor types.</summary>
    public static IReadOnlyList<string> Lines(MachineProfile profile) => [.. Typed(profile).Select(axis => $"JP{Label(axis)},_MT{axis.Letter}<>{Type(axis)}")];

    /// <summary>Where these lead: nothing was moved yet, and the tool is off.</summary>
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
