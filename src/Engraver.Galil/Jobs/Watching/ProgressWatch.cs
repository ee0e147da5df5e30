using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Whether a job gets on: it did something itself, or the controller moved or counted. Whoever waits for a motion that does not come would otherwise wait for ever, and keep the watchdog content meanwhile.</summary>
/// <remarks>Time is the controller's, so that a slow host is not taken for a stalled machine; and a single answer that came late proves nothing, so that some polls must have seen the same.</remarks>
internal sealed class ProgressWatch(MachineProfile profile)
{
    private const double SamplesPerSecond = 1000.0;
    private const int FewestPolls = 10;

    private MachineState? _last;
    private long _since;
    private int _polls;

    /// <summary>Controller seconds without progress until a job is given up.</summary>
    public double Seconds { get; } = StandstillLimit.Seconds(profile);

    /// <summary>The host had a command of the job accepted: what comes of it is waited for anew.</summary>
    public void Acted() => _last = null;

    /// <summary>To be called with each poll.</summary>
    public bool IsStalled(in MachineState now)
    {
        if (_last is not { } last || HasProgress(last, now)) (_since, _polls) = (now.Time, 0);
        _last = now;
        return ++_polls > FewestPolls && PollTimes.SamplesSince(_since, now.Time) > Seconds * SamplesPerSecond;
    }

    private static bool HasProgress(in MachineState before, in MachineState now) =>
        before.Position != now.Position || before.Counter != now.Counter || before.Calls != now.Calls || before.SequenceRunning != now.SequenceRunning || before.AxesRunning != now.AxesRunning;
}

/// <summary>How long a job may stand still, seconds of the controller's time. Motion is never so slow: at the slowest feed (2 counts/s) a position changes twice a second, so a long segment needs no allowance.</summary>
/// <remarks>What stands legitimately is added: the tool settles. The job itself sees a standstill first and can say where it was; the watchdog in the controller is for the case that it does not.</remarks>
internal static class StandstillLimit
{
    private const double JobSeconds = 3.0;
    private const double WatchdogSeconds = 6.0;
    private const double TickSeconds = 0.05;

    /// <summary>After so long without any progress a job gives up.</summary>
    public static double Seconds(MachineProfile profile) => JobSeconds + profile.ToolSettleSeconds;

    /// <summary>Ticks of the watchdog in the controller for which the tool may be on while nothing moves.</summary>
    public static int ControllerTicks(MachineProfile profile) => (int)Math.Min(1e9, Math.Ceiling((WatchdogSeconds + profile.ToolSettleSeconds) / TickSeconds));
}
