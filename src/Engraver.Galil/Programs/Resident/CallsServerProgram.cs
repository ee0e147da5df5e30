using Engraver.Core.Machines;
using Engraver.Galil.Language;
using static Engraver.Galil.Programs.Resident.ResidentProgram;

namespace Engraver.Galil.Programs.Resident;

/// <summary>The method of the paper with a host (galil-dmc.md EX11 with safeguards): the host assigns variables, then go=1; thread 0 calls the subprogram and
/// increments seq.</summary>
/// <remarks>go is cleared at the beginning of a call, and seq is incremented at its end: when the host sends the next call as soon as seq has changed, no
/// go is lost and no call runs twice.</remarks>
public static class CallsServerProgram
{
    public const string Entry = "#SERVER";

    public static string Text(MachineProfile profile) => string.Join('\n', Lines(profile)) + "\n";

    internal static IReadOnlyList<string> Lines(MachineProfile profile) =>
    [
        Entry,
        profile.Height is null ? "op=0;x=0;y=0;r=0;th=0;da=0" : "op=0;x=0;y=0;z=0;r=0;th=0;da=0",
        DmcFormat.Text($"f={profile.VectorSpeed()};va={profile.AccelerationCounts};go=0;done=1;seq=0"),
        CommandErrorProgram.ClearStatement,
        WatchdogProgram.StartStatement,
        "SH" + profile.Axes.Letters,
        .. Subprograms.SetUpLines(profile),
        "#SLOOP",
        "WT 2",
        "JP#SLOOP,go=0",
        "go=0;done=0",
        .. Dispatch(Operations.Line, Subprograms.Linear),
        .. Dispatch(Operations.Arc, Subprograms.Circular),
        .. Dispatch(Operations.Rapid, Subprograms.Rapid),
        .. profile.Height is null ? Dispatch(Operations.Tool, "#TOOL") : Dispatch(Operations.Slope, Subprograms.Slope),
        "done=1;seq=seq+1",
        "JP#SLOOP",
        "EN",
        .. Subprograms.LinearLines(profile, string.Empty),
        .. Subprograms.CircularLines(profile, string.Empty),
        .. Subprograms.RapidLines(profile, string.Empty),
        .. profile.Height is null ? ToolLines(profile) : Subprograms.SlopeLines(profile, string.Empty),
    ];

    private static IReadOnlyList<string> ToolLines(MachineProfile profile) =>
        new ProgramLines().Line("#TOOL").Line(DmcFormat.Text($"OB {profile.ToolOutput},{(profile.ToolActiveLow ? "1-x" : "x")}"), Subprograms.Settle(profile)).Line("EN").Lines;

    private static IReadOnlyList<string> Dispatch(int operation, string label) => [DmcFormat.Text($"JS{label},op={operation}")];
}
