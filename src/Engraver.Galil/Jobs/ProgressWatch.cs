using Engraver.Galil.Profiles;

namespace Engraver.Galil.Jobs;

/// <summary>Whether a job gets on: it did something itself, or the controller moved or counted. Whoever waits for a motion that does not come would otherwise wait for ever, and keep the watchdog content meanwhile.</summary>
/// <remarks>Time is the controller's, so that a slow host is not taken for a stalled machine; and a single answer that came late proves nothing, so that some polls must have seen the same.</remarks>
internal sealed class ProgressWatch(MachineProfile profile)
{
    private const double SamplesPerSecond = 1000.0;
    private const int FewestPolls = 10;

    private MachineState? _last;
    private long _since;
    private int _polls;

    /// <summary>Controller seconds without progress until a job is given up, at a rate of 1.</summary>
    public double Seconds { get; } = StandstillLimit.Seconds(profile);

    /// <summary>The host had a command of the job accepted: what comes of it is waited for anew.</summary>
    public void Acted() => _last = null;

    /// <summary>To be called with each poll.</summary>
    public bool IsStalled(in MachineState now, WatchdogLimit limit)
    {
        if (_last is not { } last || HasProgress(last, now)) (_since, _polls) = (now.Time, 0);
        _last = now;
        return ++_polls > FewestPolls && JobClock.SamplesSince(_since, now.Time) > limit.Samples((int)(Seconds * SamplesPerSecond));
    }

    private static bool HasProgress(in MachineState before, in MachineState now) =>
        before.Position != now.Position || before.Counter != now.Counter || before.Calls != now.Calls || before.SequenceRunning != now.SequenceRunning || before.AxesRunning != now.AxesRunning;
}
