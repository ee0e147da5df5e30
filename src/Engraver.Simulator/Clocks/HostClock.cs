namespace Engraver.Simulator.Clocks;

/// <summary>The controller's time, given to a host that keeps step with it: while the host has this clock, time passes only by the commands that it sends and while it waits.</summary>
/// <remarks>
/// <para>A timer that is created with a due time (<c>Task.Delay</c> on this clock) is a wait of the host: as soon as every host with a clock waits, time passes up to the first timer. A timer
/// that is created without a due time and set later is a deadline: it fires when time reaches it, and does not itself let time pass.</para>
/// <para>So a host that its computer delays loses no controller time, and the same host does the same in every run. A host must be one line of work, because the clock keeps one mark of whether
/// it waits: while one of two tasks of a host waits, time passes although the other is at work.</para>
/// <para>A host of this process is waited for without end; one of another process that says nothing for seconds is given up, and time passes without it.</para>
/// <para>Disposing gives the clock back. Without any host, time follows the wall or, at speed max, the silence of all hosts.</para>
/// </remarks>
public sealed class HostClock : TimeProvider, IDisposable
{
    private readonly HostClockCoordinator _coordinator;

    internal HostClock(HostClockCoordinator coordinator, bool isElsewhere) => (_coordinator, IsElsewhere) = (coordinator, isElsewhere);

    /// <summary>The host is another process: it may hang or die while this one lives, and is given up when it is silent for long.</summary>
    internal bool IsElsewhere { get; }

    /// <summary>Ticks of 100 ns since the controller was switched on.</summary>
    public override long TimestampFrequency => TimeSpan.TicksPerSecond;

    /// <summary>True between the creation of a wait and its end.</summary>
    internal bool IsWaiting { get; set; }

    public override long GetTimestamp() => _coordinator.Now;

    /// <summary>Counts from 1970, so that two runs write the same dates.</summary>
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
