using Engraver.Core.Machines;
using Engraver.Core.Motion.Planning;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Resident;

/// <summary>#WDOG in thread 1 (galil-dmc.md EX12): stops the machine when the host has not assigned the heartbeat for 1.0 s (host lost), and when the tool has
/// been on for too long without motion (tool forgotten), with or without a host.</summary>
/// <remarks> The trip is one line, which no other thread can interrupt. First the tool is switched off. Then the position is stored in variables, from which a
/// later session resumes the job (ADR 10). Then thread 0 is halted, because a server that waits for the end of a motion would continue with its next statement
/// as soon as the stop is complete. Then the plane and every axis are stopped. STS discards the rest of the sequence in the buffer (B.8); the host clears it
/// with CSS when it is connected again. The host assigns the heartbeat and the longest standstill before it starts the watchdog: with an undefined variable the
/// line is refused, and nothing moves. Standstill means that no axis moves and the buffer (<c>_LMS</c>) does not change: a host that sends a sequence over a
/// slow line while the tool is on is active. </remarks>
public static class WatchdogProgram
{
    /// <summary>Values of <see cref="ResidentProgram.Variables.WatchdogTripped"/>.</summary>
    public const int HeartbeatLost = 1;
    public const int ToolForgotten = 2;

    internal static string StartStatement { get; } = DmcFormat.Text($"XQ#WDOG,{ResidentProgram.WatchdogThread}");

    public static string Text(MachineProfile profile) => string.Join('\n', Lines(profile)) + "\n";

    internal static IReadOnlyList<string> Lines(MachineProfile profile)
    {
        const string Heartbeat = ResidentProgram.Variables.Heartbeat;
        const string Still = ResidentProgram.Variables.StandstillTicks;
        return new ProgramLines()
            .Line("#WDOG")
            .Line($"{ResidentProgram.Variables.WatchdogTripped}=0")
            .Line("#WLIVE")
            .Line(StorePosition(profile))
            .Line("#WLOOP")
            .Line("WT 50")
            .Line($"{Heartbeat}={Heartbeat}-1", $"{Still}={Still}+1")
            .Line($"JP#WLOST,{Heartbeat}<=0")
            .Line($"JP#WLIVE,{ActivityCondition(profile)}")
            .Line($"JP#WLOOP,{Still}<{ResidentProgram.Variables.StandstillTickLimit}")
            .Line(Trip(profile, ToolForgotten))
            .Line(profile.Height is null ? Subprograms.RestOff(profile) : string.Empty)
            .Line("MG \"STANDSTILL\"")
            .Line(profile.Height is null ? "EN" : "JP#WUP")
            .Line("#WLOST")
            .Line(Trip(profile, HeartbeatLost))
            .Line(profile.Height is null ? Subprograms.RestOff(profile) : string.Empty)
            .Line("MG \"HOST LOST\"")
            .Line(profile.Height is null ? "EN" : "JP#WUP")
            .Lines.Concat(RaiseLines(profile)).ToList();
    }

    /// <summary>Stores the position of the machine and restarts the count of its standstill.</summary>
    internal static string StorePosition(MachineProfile profile) => string.Join(';', [$"{ResidentProgram.Variables.StandstillTicks}=0", .. Watched(profile).Select(axis => $"{axis.Kept}={axis.Operand}"), "wl=_LMS"]);

    /// <summary>True while the machine moves, receives segments, or has its tool off the work, as a condition of JP.</summary>
    internal static string ActivityCondition(MachineProfile profile) => $"{string.Concat(Watched(profile).Select(axis => $"({axis.Operand}<>{axis.Kept})|"))}(_LMS<>wl)|({ToolIsAway(profile)})";

    private static IEnumerable<(string Operand, string Kept)> Watched(MachineProfile profile) => profile.Axes.Letters.Select((letter, i) => ($"_RP{letter}", $"w{"abc"[i]}"));

    /// <summary>If an axis holds the tool: when the machine has braked, the tool is raised vertically out of its cut, and then the spindle is switched off (ADR
    /// 11). A sequence that ran dry is still open then, and only AB1 ends it (galil-dmc.md B.7).</summary>
    private static IReadOnlyList<string> RaiseLines(MachineProfile profile) => profile.Axes.Z is not { } z || profile.Height is null ? [] : new ProgramLines()
        .Line("#WUP")
        .Line(DmcFormat.Text($"WT {DmcProfile.EvenMilliseconds(LongestBrake(profile) + 0.1)}"))
        .Line("JP#WUQ,_BGS=0")
        .Line("AB1")
        .Line("#WUQ")
        .Line("JP#WUR," + Subprograms.IsUp(profile, Subprograms.ClearanceHeight))
        .Line(Subprograms.HeightLine(profile, profile.RapidSpeed(z), Subprograms.ClearanceHeight))
        .Line("#WUR")
        .Line(Subprograms.RestOff(profile))
        .Line("EN")
        .Lines;

    /// <summary>Time from the fastest motion of a job to rest, seconds: on the path at the smallest VD of any plan, in a rapid at the DC of the axes.</summary>
    private static double LongestBrake(MachineProfile profile)
    {
        double Counts(double mmPerMinute) => profile.Scale.Diagonal.CountsOf(mmPerMinute / 60.0);
        var onPath = SpeedPlanner.LeastAcceleration(PathLimits.Of(profile), DmcLimits.AccelerationStep);
        return Math.Max(Counts(profile.FeedMmPerMinute) / onPath, Counts(profile.RapidMmPerMinute) / profile.Axes.All.Min(profile.RapidAcceleration));
    }

    /// <summary>While the tool is off the work, standstill has no time limit.</summary>
    private static string ToolIsAway(MachineProfile profile) => profile.Height is null ? DmcFormat.Text($"@OUT[{profile.ToolOutput}]={(profile.ToolActiveLow ? 1 : 0)}") : Subprograms.IsUp(profile, Subprograms.ClearanceHeight);

    private static string Trip(MachineProfile profile, int why) => Subprograms.Statements(
        Subprograms.ToolOff(profile),
        Place(profile),
        DmcFormat.Text($"{ResidentProgram.Variables.WatchdogTripped}={why}"),
        DmcFormat.Text($"HX{ResidentProgram.MainThread}"),
        "STS",
        "ST" + profile.Axes.Letters,
        $"{ResidentProgram.Variables.TripMark}={ResidentProgram.Variables.JobMark}");

    /// <summary>The position at which the tool was switched off, or started to brake in the work, for a later resume.</summary>
    private static string Place(MachineProfile profile) =>
        $"{ResidentProgram.Variables.TripCounter}=_CSS;{ResidentProgram.Variables.TripX}=_RP{profile.Axes.X.Letter};{ResidentProgram.Variables.TripY}=_RP{profile.Axes.Y.Letter};{(profile.Axes.Z is { } z && profile.Height is not null ? $"{ResidentProgram.Variables.TripZ}=_RP{z.Letter};" : "")}{ResidentProgram.Variables.TripDistance}=_AVS";
}
