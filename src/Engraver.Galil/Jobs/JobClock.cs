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

    /// <summary>So many polls follow each other without a pause, at the start of a job and in every period: where time is the commands received, the pauses hide that it runs ahead. A real controller answers them all in 0.1 s.</summary>
    private const int PollsInARow = 30;
    private const int PollsInAPeriod = 180;

    private long? _start;
    private long _sample;
    private long _sampleBefore;
    private long _asking;
    private long _askedBefore;
    private long _polledAt;
    private int _polls;
    private bool _isRow;

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

    /// <summary>Also in the middle of a job it is seen whether the controller's clock runs ahead: the comparison at connect is spoiled by a host that was busy just then. From before an earlier question to now is at least the time between the two samples, so that no answer that was held up makes a real controller look fast.</summary>
    /// <param name="sample">TIME, as the answer to the question has it.</param>
    public void Polled(long sample)
    {
        var samples = SamplesSince(_sampleBefore, sample);
        if (_start is not null && samples >= ClockSamples && samples * sampleSeconds > ClockFactor * time.GetElapsedTime(_askedBefore).TotalSeconds) RunsAhead = true;
        if (!_isRow) (_sampleBefore, _askedBefore) = (sample, _asking);
        (_sample, _polledAt) = (sample, time.GetTimestamp());
        _start ??= sample;
    }

    /// <summary>Between two polls; none where the controller's time runs ahead of ours, and none in a row.</summary>
    public async ValueTask PauseAsync(CancellationToken stop)
    {
        if (RunsAhead || pollInterval <= TimeSpan.Zero) return;
        _isRow = _polls++ % PollsInAPeriod < PollsInARow;
        if (!_isRow) await Task.Delay(pollInterval, time, stop).ConfigureAwait(false);
    }
}
