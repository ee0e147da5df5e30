namespace Engraver.Galil.Tests.Jobs;

/// <summary>An artificial wall clock: every reading takes a fixed time, every short pause its length, and long time-outs never fire. A run does not depend on
/// the computer.</summary>
internal sealed class AdvancingTimeProvider : TimeProvider
{
    private static readonly TimeSpan PerLook = TimeSpan.FromMicroseconds(20);
    private static readonly TimeSpan LongestPause = TimeSpan.FromSeconds(0.2);

    private long _now;

    /// <summary>The same clock for code that only reads it: its timers never fire.</summary>
    public TimeProvider WithoutTimers => new Onlooker(this);

    public override long TimestampFrequency => TimeSpan.TicksPerSecond;

    public override long GetTimestamp() => Interlocked.Add(ref _now, PerLook.Ticks);

    public void Pass(TimeSpan time) => Interlocked.Add(ref _now, time.Ticks);

    public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
    {
        if (dueTime < TimeSpan.Zero || dueTime > LongestPause) return new Never();
        Pass(dueTime);
        return TimeProvider.System.CreateTimer(callback, state, TimeSpan.Zero, Timeout.InfiniteTimeSpan);
    }

    private sealed class Onlooker(AdvancingTimeProvider time) : TimeProvider
    {
        public override long TimestampFrequency => time.TimestampFrequency;

        public override long GetTimestamp() => time.GetTimestamp();

        public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period) => new Never();
    }

    private sealed class Never : ITimer
    {
        public bool Change(TimeSpan dueTime, TimeSpan period) => true;

        public void Dispose()
        {
        }

        public ValueTask DisposeAsync() => ValueTask.CompletedTask;
    }
}
