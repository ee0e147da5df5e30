namespace Engraver.Galil.Jobs.Watching;

/// <summary>The times of a job's polls, by the controller's samples and by the job's clock.</summary>
/// <param name="time">The job's clock.</param>
/// <param name="sampleSeconds">A sample of the nominal length TM, in seconds.</param>
internal sealed class PollTimes(TimeProvider time, double sampleSeconds)
{
    private long? _start;
    private long _sample;
    private long _polledAt;

    /// <summary>Time since the last poll.</summary>
    public TimeSpan SincePoll => time.GetElapsedTime(_polledAt);

    /// <summary>Controller time from the first poll to the last, in nominal samples.</summary>
    public double Seconds => _start is { } start ? SamplesSince(start, _sample) * sampleSeconds : 0.0;

    /// <summary>Samples between two values of TIME, which wraps at 2^31.</summary>
    public static long SamplesSince(long from, long to) => to >= from ? to - from : to - from + (1L << 31);

    /// <param name="sample">TIME in the reply to the poll.</param>
    public void Polled(long sample)
    {
        (_sample, _polledAt) = (sample, time.GetTimestamp());
        _start ??= sample;
    }
}
