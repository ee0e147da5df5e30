using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Detects a job without progress: it sent no command, and the controller neither moved nor counted. Otherwise the job would wait for ever for a motion that does not come, and keep the watchdog from tripping.</summary>
/// <remarks>Measured in controller time, so that a slow host does not look like a stalled machine; and by several polls, because a single late answer proves nothing.</remarks>
internal sealed class ProgressWatch(MachineProfile profile)
{
    private const double SamplesPerSecond = 1000.0;
    private const int FewestPolls = 10;

    private MachineState? _last;
    private long _since;
    private int _polls;

    /// <summary>Controller seconds without progress until a job is given up.</summary>
    public double Seconds { get; } = StandstillLimit.Seconds(profile);

    /// <summary>The controller accepted a command of the job: the time without progress starts anew.</summary>
    public void Acted() => _last = null;

    /// <summary>Call with each poll.</summary>
    public bool IsStalled(in MachineState now)
    {
        if (_last is not { } last || HasProgress(last, now)) (_since, _polls) = (now.Time, 0);
        _last = now;
        return ++_polls > FewestPolls && PollTimes.SamplesSince(_since, now.Time) > Seconds * SamplesPerSecond;
    }

    private static bool HasProgress(in MachineState before, in MachineState now) =>
        before.Position != now.Position || before.Counter != now.Counter || before.Calls != now.Calls || before.SequenceRunning != now.SequenceRunning || before.AxesRunning != now.AxesRunning;
}

/// <summary>How long a job may be without progress, controller seconds. Motion is never so slow: at the slowest feed (2 counts/s) a position changes twice a second, so a long segment needs no allowance.</summary>
/// <remarks>The tool's settle time is added. The job itself notices a standstill first and can say where it was; the watchdog in the controller is for the case that it does not.</remarks>
internal static class StandstillLimit
{
    private const double JobSeconds = 3.0;
    private const double WatchdogSeconds = 6.0;
    private const double TickSeconds = 0.05;

    /// <summary>More than an hour; so that the line that assigns it stays one line.</summary>
    private const double MostTicks = 99_999.0;

    /// <summary>Time without progress after which a job is given up.</summary>
    public static double Seconds(MachineProfile profile) => JobSeconds + LongestWait(profile);

    private static double LongestWait(MachineProfile profile) => Math.Max(Math.Max(profile.ToolSettleSeconds, profile.OffSettleSeconds), profile.Spindle?.SpinUpSeconds ?? 0.0);

    /// <summary>Ticks of the watchdog in the controller for which the tool may be on while nothing moves.</summary>
    public static int ControllerTicks(MachineProfile profile) => (int)Math.Min(MostTicks, Math.Ceiling((WatchdogSeconds + profile.ToolSettleSeconds) / TickSeconds));
}
