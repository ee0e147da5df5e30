using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>Controller time and wall time of a job, by its polls.</summary>
internal sealed class JobClock(ControllerSession session, TimeSpan pollInterval)
{
    /// <summary>Controller time that ran so much faster than the wall between two polls is no jitter.</summary>
    private const int ClockSamples = 30;
    private const double ClockFactor = 3.0;

    private long? _start;
    private long _sample;
    private long _polledAt;
    private bool _runsAhead;

    /// <summary>Wall time since the last poll.</summary>
    public TimeSpan SincePoll => session.Time.GetElapsedTime(_polledAt);

    /// <summary>Controller time from the first poll to the last: samples of the nominal length TM.</summary>
    public double Seconds => _start is { } start ? SamplesSince(start, _sample) * (session.Identity.Limits.SampleMicroseconds ?? 1000) / 1e6 : 0.0;

    /// <summary>The counter wraps at 2^31.</summary>
    public static long SamplesSince(long from, long to) => to >= from ? to - from : to - from + (1L << 31);

    /// <summary>Also in the middle of a job it is seen whether the controller's clock runs ahead: the comparison at connect is spoiled by a host that was busy just then.</summary>
    /// <param name="sample">TIME.</param>
    public void Polled(long sample)
    {
        var samples = sample - _sample;
        if (_sample > 0 && samples >= ClockSamples && samples > ClockFactor * SincePoll.TotalMilliseconds) _runsAhead = true;
        (_sample, _polledAt) = (sample, session.Time.GetTimestamp());
        _start ??= sample;
    }

    /// <summary>Between two polls; none where the controller's time runs ahead of ours.</summary>
    public async ValueTask PauseAsync(CancellationToken stop)
    {
        if (!_runsAhead && pollInterval > TimeSpan.Zero) await Task.Delay(pollInterval, session.Time, stop).ConfigureAwait(false);
    }
}
