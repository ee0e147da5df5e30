namespace Engraver.Simulator.Clocks;

/// <summary>The controller's time, given to a host that keeps step with it: while it has this clock, time goes on only by the commands that it sends and while it waits.</summary>
/// <remarks>
/// <para>A timer that is created with a time to go (<c>Task.Delay</c> on this clock) is a wait of the host: time goes on to the first timer as soon as every host that has a clock waits. A timer
/// that is created at rest and set later is a deadline: it fires when time passes it, and lets no time pass.</para>
/// <para>So a host that is held up by its computer finds no time gone, and the same host does the same in every run. One host is one line of work: with two of its waits under way at once the
/// clock takes it for waiting until it goes on.</para>
/// <para>Disposing gives the clock back: without any host time follows the wall or, at speed max, the silence of all hosts.</para>
/// </remarks>
public sealed class HostClock : TimeProvider, IDisposable
{
    private readonly HostDesk _desk;

    internal HostClock(HostDesk desk) => _desk = desk;

    /// <summary>Ticks of 100 ns since the controller was switched on.</summary>
    public override long TimestampFrequency => TimeSpan.TicksPerSecond;

    /// <summary>True between the creation of a wait and its end.</summary>
    internal bool IsWaiting { get; set; }

    public override long GetTimestamp() => _desk.Now;

    /// <summary>Counted from 1970, so that two runs write the same dates.</summary>
    public override DateTimeOffset GetUtcNow() => DateTimeOffset.UnixEpoch + TimeSpan.FromTicks(GetTimestamp());

    public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
    {
        ArgumentNullException.ThrowIfNull(callback);
        var timer = new HostTimer(_desk, this, callback, state);
        if (dueTime == Timeout.InfiniteTimeSpan) return timer;
        _desk.Set(timer, dueTime, period, isWait: true);
        _desk.PassWhileAllWait(timer);
        return timer;
    }

    public void Dispose() => _desk.Leave(this);
}
