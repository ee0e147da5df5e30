using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Resident;

/// <summary>#WDOG in thread 1 (galil-dmc.md EX12): the host that does not assign the heartbeat for 1.0 s is taken for lost, and a tool that is on while nothing moves for too long is taken for
/// forgotten, host or no host. Either way the machine is stopped.</summary>
/// <remarks>
/// The trip is one line, which no other thread can interrupt: tool off first; then thread 0 is halted, because a server that waits for the end of a motion would go on
/// with its next statement as soon as the stop is done; then the plane and both axes are stopped. What a sequence still had in the buffer is given up by STS (B.8);
/// the host clears it with CSS when it is back. The host winds it up, and says how long a standstill may last, before it starts it: undefined, either is a refused line, and nothing moves.
/// Standstill is neither axis and no change of the buffer (<c>_LMS</c>): a host that feeds a sequence over a slow line while the tool is on is at work.
/// </remarks>
public static class WatchdogProgram
{
    /// <summary>Values of <see cref="ResidentProgram.Variables.WatchdogTripped"/>.</summary>
    public const int HostLost = 1;
    public const int ToolForgotten = 2;

    internal static string StartStatement { get; } = Subprograms.Text($"XQ#WDOG,{ResidentProgram.WatchdogThread}");

    public static string Text(MachineProfile profile) => string.Join('\n', Lines(profile)) + "\n";

    internal static IReadOnlyList<string> Lines(MachineProfile profile)
    {
        const string Heartbeat = ResidentProgram.Variables.Heartbeat;
        const string Still = ResidentProgram.Variables.Still;
        var (x, y) = (profile.Axes.X.Letter, profile.Axes.Y.Letter);
        return new ProgramLines()
            .Line("#WDOG")
            .Line($"{ResidentProgram.Variables.WatchdogTripped}=0")
            .Line("#WLIVE")
            .Line($"{Still}=0", $"wa=_RP{x}", $"wb=_RP{y}", "wl=_LMS")
            .Line("#WLOOP")
            .Line("WT 50")
            .Line($"{Heartbeat}={Heartbeat}-1", $"{Still}={Still}+1")
            .Line($"JP#WLOST,{Heartbeat}<=0")
            .Line(Subprograms.Text($"JP#WLIVE,(_RP{x}<>wa)|(_RP{y}<>wb)|(_LMS<>wl)|(@OUT[{profile.ToolOutput}]=0)"))
            .Line($"JP#WLOOP,{Still}<{ResidentProgram.Variables.StillLimit}")
            .Line(Trip(profile, ToolForgotten))
            .Line("MG \"STANDSTILL\"")
            .Line("EN")
            .Line("#WLOST")
            .Line(Trip(profile, HostLost))
            .Line("MG \"HOST LOST\"")
            .Line("EN")
            .Lines;
    }

    private static string Trip(MachineProfile profile, int why) =>
        Subprograms.Text($"{Subprograms.ToolOff(profile)};{ResidentProgram.Variables.WatchdogTripped}={why};HX{ResidentProgram.MainThread};STS;ST{profile.Axes.Letters}");
}
