using Engraver.Core.Machines;

namespace Engraver.Galil.Programs;

/// <summary>Maximum time of a job without progress, controller seconds. Motion is never that slow: at the lowest feed (2 counts/s) a position changes twice a
/// second, so a long segment needs no allowance.</summary>
/// <remarks>The tool's settle time and the longest wait of an operation are added. Usually the job itself detects a standstill first and can report its
/// position; the watchdog in the controller is the fallback.</remarks>
internal static class StandstillLimit
{
    private const double JobSeconds = 3.0;
    private const double WatchdogSeconds = 6.0;

    /// <summary>One tick of the watchdog in the controller (WT 50).</summary>
    internal const double TickSeconds = 0.05;

    /// <summary>More than an hour, limited so that the line that assigns it is one line.</summary>
    private const double MaxTicks = 99_999.0;

    /// <summary>Time without progress after which a job is stopped.</summary>
    /// <param name="wait">The longest wait that an operation states, seconds.</param>
    public static double Seconds(MachineProfile profile, double wait) => JobSeconds + Math.Max(LongestWait(profile), wait);

    private static double LongestWait(MachineProfile profile) => Math.Max(Math.Max(profile.ToolSettleSeconds, profile.OffSettleSeconds), profile.Spindle?.SpinUpSeconds ?? 0.0);

    /// <summary>Ticks of the watchdog in the controller for which the tool may be on without motion.</summary>
    /// <param name="wait">The longest wait that an operation states, seconds.</param>
    public static int ControllerTicks(MachineProfile profile, double wait) => (int)Math.Min(MaxTicks, Math.Ceiling((WatchdogSeconds + profile.ToolSettleSeconds + wait) / TickSeconds));
}
