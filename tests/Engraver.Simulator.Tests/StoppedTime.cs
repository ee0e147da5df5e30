namespace Engraver.Simulator.Tests;

/// <summary>A wall clock that stands until a test moves it; its timers fire inside <see cref="Advance"/>.</summary>
internal sealed class StoppedTime : TimeProvider
{
    private readonly List<ManualTimer> _timers = [];
    private long _now;

    /// <summary>Callbacks of timers so far.</summary>
    public int Ticks { get; private set; }

    /// <summary>Thrown by the next look at the clock: a bug where no test can put one otherwise.</summary>
    public Exception? Bug { get; set; }

    public override long TimestampFrequency => TimeSpan.TicksPerSecond;

    /// <summary>So long does the next look at the clock take, and then none any more.</summary>
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

    private sealed class ManualTimer(StoppedTime owner, TimerCallback callback, object? state) : ITimer
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
