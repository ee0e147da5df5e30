using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Resident;

/// <summary>#WDOG in thread 1 (galil-dmc.md EX12): stops the machine when the host has not assigned the heartbeat for 1.0 s (host lost), and when the tool has been on for too long while nothing
/// moves (tool forgotten), with or without a host.</summary>
/// <remarks>
/// The trip is one line, which no other thread can interrupt: tool off first; then thread 0 is halted, because a server that waits for the end of a motion would go on
/// with its next statement as soon as the stop is done; then the plane and both axes are stopped. STS drops the rest of the sequence in the buffer (B.8);
/// the host clears it with CSS when it is back. The host assigns the heartbeat and the longest standstill before it starts the watchdog: undefined, either is a refused line, and nothing moves.
/// Standstill means that no axis moves and the buffer (<c>_LMS</c>) does not change: a host that sends a sequence over a slow line while the tool is on is at work.
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
