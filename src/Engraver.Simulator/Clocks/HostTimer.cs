namespace Engraver.Simulator.Clocks;

/// <summary>A timer on a host's clock. All members except the callback are guarded by the controller's lock.</summary>
internal sealed class HostTimer(HostClockCoordinator coordinator, HostClock host, TimerCallback callback, object? state) : ITimer
{
    public HostClock Host => host;

    /// <summary>Controller time at which it fires, ticks; <see cref="long.MaxValue"/> while stopped.</summary>
    public long Due { get; set; } = long.MaxValue;

    /// <summary>Ticks between two firings; with 0 the timer fires only once.</summary>
    public long Period { get; set; }

    /// <summary>The host waits for this timer, so that time can advance to it.</summary>
    public bool IsWait { get; set; }

    /// <summary>Sequence number of the wait: waits are numbered in the order in which they started.</summary>
    public long Started { get; set; }

    public void Fire() => callback(state);

    public bool Change(TimeSpan dueTime, TimeSpan period)
    {
        coordinator.Set(this, dueTime, period, isWait: false);
        return true;
    }

    public void Dispose() => coordinator.Set(this, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan, isWait: false);

    public ValueTask DisposeAsync()
    {
        Dispose();
        return ValueTask.CompletedTask;
    }
}
