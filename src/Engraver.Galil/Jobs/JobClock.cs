namespace Engraver.Galil.Jobs;

/// <summary>Controller time and wall time of a job, by its polls.</summary>
/// <param name="time">The clock of the wall.</param>
/// <param name="sampleSeconds">A sample of the nominal length TM, in seconds.</param>
/// <param name="pollInterval">The pause between two polls.</param>
internal sealed class JobClock(TimeProvider time, double sampleSeconds, TimeSpan pollInterval)
{
    /// <summary>Controller time that ran so much faster than the wall between two polls is no jitter.</summary>
    private const int ClockSamples = 30;
    private const double ClockFactor = 3.0;

    private long? _start;
    private long _sample;
    private long _asking;
    private long _asked;
    private long _polledAt;

    /// <summary>Wall time since the last poll.</summary>
    public TimeSpan SincePoll => time.GetElapsedTime(_polledAt);

    /// <summary>Whether it was proved between two polls that the controller's time runs ahead of ours.</summary>
    public bool RunsAhead { get; private set; }

    /// <summary>Controller time from the first poll to the last.</summary>
    public double Seconds => _start is { } start ? SamplesSince(start, _sample) * sampleSeconds : 0.0;

    /// <summary>The counter wraps at 2^31.</summary>
    public static long SamplesSince(long from, long to) => to >= from ? to - from : to - from + (1L << 31);

    /// <summary>To be called before the question of a poll is sent.</summary>
    public void Asks() => _asking = time.GetTimestamp();

    /// <summary>Also in the middle of a job it is seen whether the controller's clock runs ahead: the comparison at connect is spoiled by a host that was busy just then. From before the last question to now is at least the time between the two samples, so that no answer that was held up makes a real controller look fast.</summary>
    /// <param name="sample">TIME, as the answer to the question has it.</param>
    public void Polled(long sample)
    {
        var samples = sample - _sample;
        if (_start is not null && samples >= ClockSamples && samples * sampleSeconds > ClockFactor * time.GetElapsedTime(_asked).TotalSeconds) RunsAhead = true;
        (_sample, _asked, _polledAt) = (sample, _asking, time.GetTimestamp());
        _start ??= sample;
    }

    /// <summary>Between two polls; none where the controller's time runs ahead of ours.</summary>
    public async ValueTask PauseAsync(CancellationToken stop)
    {
        if (!RunsAhead && pollInterval > TimeSpan.Zero) await Task.Delay(pollInterval, time, stop).ConfigureAwait(false);
    }
}
