using Engraver.Galil.Profiles;

namespace Engraver.Galil.Programs;

/// <summary>#WDOG in thread 1 (galil-dmc.md EX12): the host that does not assign the heartbeat for 1.0 s is taken for lost, and the machine is stopped.</summary>
/// <remarks>
/// The trip is one line, which no other thread can interrupt: tool off first; then thread 0 is halted, because a server that waits for the end of a motion would go on
/// with its next statement as soon as the stop is done; then the plane and both axes are stopped. What a sequence still had in the buffer is given up by STS (B.8);
/// the host clears it with CSS when it is back. The host winds it up before it starts it: undefined, the heartbeat is a refused line, and nothing moves.
/// </remarks>
public static class WatchdogProgram
{
    internal static string StartStatement { get; } = Subprograms.Text($"XQ#WDOG,{ResidentProgram.WatchdogThread}");

    public static string Text(MachineProfile profile) => string.Join('\n', Lines(profile)) + "\n";

    internal static IReadOnlyList<string> Lines(MachineProfile profile)
    {
        const string Heartbeat = ResidentProgram.Variables.Heartbeat;
        return
        [
            "#WDOG",
            $"{ResidentProgram.Variables.WatchdogTripped}=0",
            "#WLOOP",
            "WT 50",
            $"{Heartbeat}={Heartbeat}-1",
            $"JP#WLOOP,{Heartbeat}>0",
            Subprograms.Text($"{Subprograms.ToolOff(profile)};{ResidentProgram.Variables.WatchdogTripped}=1;HX{ResidentProgram.MainThread};STS;STAB"),
            "MG \"HOST LOST\"",
            "EN",
        ];
    }
}
