namespace Engraver.Simulator.Tests;

/// <summary>A wall clock that advances only in <see cref="Advance"/>, where its timers fire.</summary>
internal sealed class StoppedTimeProvider : TimeProvider
{
    private readonly List<ManualTimer> _timers = [];
    private long _now;

    /// <summary>Number of timer callbacks so far.</summary>
    public int Ticks { get; private set; }

    /// <summary>Thrown by the next reading of the clock: an internal error at a point that a test cannot reach otherwise.</summary>
    public Exception? Bug { get; set; }

    public override long TimestampFrequency => TimeSpan.TicksPerSecond;

    /// <summary>Duration of the next reading of the clock; later readings take no time.</summary>
    public Queue<TimeSpan> Delays { get; } = [];

    public override long GetTimestamp() => Bug is { } bug ? throw bug : _now += Delays.TryDequeue(out var delay) ? delay.Ticks : 0;

    public override DateTimeOffset GetUtcNow() => new(_now, TimeSpan.Zero);

    public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
    {
        var timer = new ManualTimer(this, callback, state);
        timer.Change(dueTime, period);
        _timers.Add(timer);
        return timer;
    }

    public void Advance(TimeSpan time)
    {
        var end = _now + time.Ticks;
        while (_timers.Where(t => t.Due <= end).MinBy(t => t.Due) is { } next)
        {
            _now = next.Due;
            Ticks++;
            next.Fire();
        }

        _now = end;
    }

    private sealed class ManualTimer(StoppedTimeProvider owner, TimerCallback callback, object? state) : ITimer
    {
        private TimeSpan period;

        public long Due { get; private set; } = long.MaxValue;

        public bool Change(TimeSpan dueTime, TimeSpan newPeriod)
        {
            period = newPeriod;
            Due = dueTime == Timeout.InfiniteTimeSpan ? long.MaxValue : owner._now + dueTime.Ticks;
            return true;
        }

        public void Fire()
        {
            Due = period == Timeout.InfiniteTimeSpan || period == TimeSpan.Zero ? long.MaxValue : Due + period.Ticks;
            callback(state);
        }

        public void Dispose() => Due = long.MaxValue;

        public ValueTask DisposeAsync()
        {
            Dispose();
            return ValueTask.CompletedTask;
        }
    }
}
