using Engraver.Galil.Profiles;

namespace Engraver.Galil.Jobs;

/// <summary>How long a job may stand still, seconds of the controller's time at a rate of 1. Motion is never so slow: at the slowest feed (2 counts/s) a position changes twice a second, so a long segment needs no allowance.</summary>
/// <remarks>What stands legitimately is added: the tool settles. The job itself sees a standstill first and can say where it was; the watchdog in the controller is for the case that it does not.</remarks>
internal static class StandstillLimit
{
    private const double JobSeconds = 3.0;
    private const double WatchdogSeconds = 6.0;
    private const double TickSeconds = 0.05;

    /// <summary>After so long without any progress a job gives up.</summary>
    public static double Seconds(MachineProfile profile) => JobSeconds + profile.ToolSettleSeconds;

    /// <summary>Ticks of the watchdog in the controller for which the tool may be on while nothing moves.</summary>
    public static int ControllerTicks(MachineProfile profile, WatchdogLimit limit) =>
        (int)Math.Min(1e9, Math.Ceiling(limit.Samples((int)((WatchdogSeconds + profile.ToolSettleSeconds) * 1000)) / (TickSeconds * 1000)));
}
