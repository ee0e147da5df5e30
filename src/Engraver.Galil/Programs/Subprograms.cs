using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs;

/// <summary>The routines in the controller for job mode calls, as lines: the paper's #LINEAR, corrected (galil-dmc.md F.0, EX1), and the #CIRC that it does not print.</summary>
internal static class Subprograms
{
    public const string Linear = "#LINEAR";
    public const string Circ = "#CIRC";
    public const string Rapid = "#RAPID";
    public const string CommandError = "#CMDERR";

    /// <summary>Cuts a straight line to x, y relative to the machine's position, and waits for its end.</summary>
    /// <param name="last">A statement before the return ("seq=seq+1"), or empty.</param>
    public static IReadOnlyList<string> LinearLines(MachineProfile profile, string last) => Interpolation(profile, Linear, "VP x,y", last);

    /// <summary>Cuts an arc of radius r that begins at angle th of its circle and sweeps da, and waits for its end.</summary>
    public static IReadOnlyList<string> CircLines(MachineProfile profile, string last) => Interpolation(profile, Circ, "CR r,th,da", last);

    /// <summary>Travels to x, y in the controller's own coordinates, each axis at its speed, and waits for the end.</summary>
    public static IReadOnlyList<string> RapidLines(MachineProfile profile, string last) => RapidLines(profile, TargetLine(profile, "x", "y"), last);

    /// <param name="target">The line that assigns PA.</param>
    /// <param name="last">A statement before the return, or empty.</param>
    public static IReadOnlyList<string> RapidLines(MachineProfile profile, string target, string last) =>
        new ProgramLines().Line(Rapid).Line(target).Line("BG" + profile.Axes.Letters).Line("AM" + profile.Axes.Letters).Line(last).Line("EN").Lines;

    /// <summary>PA of both axes.</summary>
    public static string TargetLine(MachineProfile profile, string x, string y) => $"PA{profile.Axes.X.Letter}={x};PA{profile.Axes.Y.Letter}={y}";

    /// <summary>Plane S, speeds and accelerations of the profile. VS is sent with every sequence. Only valid at rest.</summary>
    public static IReadOnlyList<string> SetUpLines(MachineProfile profile)
    {
        var acceleration = profile.AccelerationCounts;
        return new ProgramLines()
            .Line("CAS", Text($"VA {acceleration}"), Text($"VD {acceleration}"))
            .Line([.. AccelerationCommands(profile)])
            .Line([.. profile.Axes.All.Select(axis => Text($"SP{axis.Letter}={profile.RapidSpeed(axis)}"))])
            .Lines;
    }

    /// <summary>AC and DC of every axis of the job.</summary>
    public static IReadOnlyList<string> AccelerationCommands(MachineProfile profile) =>
        [.. profile.Axes.All.Select(axis => Text($"AC{axis.Letter}={profile.AccelerationCounts}")), .. profile.Axes.All.Select(axis => Text($"DC{axis.Letter}={profile.AccelerationCounts}"))];

    public static string ToolOn(MachineProfile profile) => Text($"SB{profile.ToolOutput}");

    public static string ToolOff(MachineProfile profile) => Text($"CB{profile.ToolOutput}");

    /// <summary>The wait after a change of the tool; empty when the profile wants none.</summary>
    public static string Settle(MachineProfile profile) => profile.SettleMilliseconds() == 0 ? string.Empty : Text($"WT {profile.SettleMilliseconds()}");

    /// <summary>Tool off before anything else, then every motion of the plane and of its axes is stopped. One line, so that no other thread runs in between.</summary>
    public static string StopEverything(MachineProfile profile) => $"{ToolOff(profile)};STS;ST{profile.Axes.Letters}";

    public static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    private static IReadOnlyList<string> Interpolation(MachineProfile profile, string label, string segment, string last) =>
        new ProgramLines().Line(label).Line("VM" + profile.Axes.Letters).Line("VS f").Line(segment).Line("VE").Line("BGS").Line("AMS").Line(last).Line("EN").Lines;
}
