namespace Engraver.Simulator.Clocks;

/// <summary>The controller's time as a clock for a host that runs in step with the controller. While the host has this clock, time passes only with the
/// commands that it sends and while it waits.</summary>
/// <remarks>
/// <para>A timer that is created with a due time (<c>Task.Delay</c> on this clock) is a wait of the host: as soon as every host with a clock waits, time
/// advances to the first timer. A timer
/// that is created without a due time and set later is a deadline: it fires when time reaches it, but does not advance time.</para>
/// <para>A host that is delayed by its computer therefore loses no controller time and behaves identically in every run. A host must be one sequential task,
/// because the clock keeps one flag that states whether
/// the host waits: while one of two tasks of a host waits, time passes although the other task is working.</para>
/// <para>A host in this process is waited for indefinitely. A host in another process that is silent for several seconds is considered lost, and time passes
/// without it.</para>
/// <para>Disposing returns the clock. When no host has the clock, time follows the wall clock or, at speed max, the silence of all hosts.</para>
/// </remarks>
public sealed class HostClock : TimeProvider, IDisposable
{
    private readonly HostClockCoordinator _coordinator;

    internal HostClock(HostClockCoordinator coordinator, bool isElsewhere) => (_coordinator, IsElsewhere) = (coordinator, isElsewhere);

    /// <summary>The host is another process: it can hang or end while this process runs, and is considered lost after a long silence.</summary>
    internal bool IsElsewhere { get; }

    /// <summary>Ticks of 100 ns since the controller was switched on.</summary>
    public override long TimestampFrequency => TimeSpan.TicksPerSecond;

    /// <summary>True between the creation of a wait and its end.</summary>
    internal bool IsWaiting { get; set; }

    public override long GetTimestamp() => _coordinator.Now;

    /// <summary>The controller's time, counted from 1970 so that two runs write the same dates.</summary>
    public override DateTimeOffset GetUtcNow() => DateTimeOffset.UnixEpoch + TimeSpan.FromTicks(GetTimestamp());

    public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
    {
        ArgumentNullException.ThrowIfNull(callback);
        var timer = new HostTimer(_coordinator, this, callback, state);
        if (dueTime == Timeout.InfiniteTimeSpan) return timer;
        _coordinator.Set(timer, dueTime, period, isWait: true);
        _coordinator.PassWhileAllWait(timer);
        return timer;
    }

    public void Dispose() => _coordinator.Leave(this);
}
