namespace Engraver.Simulator.Clocks;

/// <summary>Decides when controller time passes. While hosts have the clock, time passes only while they wait and send commands. Otherwise it follows the wall
/// clock or, at speed max, advances with commands and silence. All members are called under the controller's lock.</summary>
internal sealed class ControllerClock(Machine machine, SimulatorOptions options)
{
    /// <summary>Maximum controller time that passes during one wait of a host before another thread can take the lock.</summary>
    private const long LongestStep = TimeSpan.TicksPerSecond;

    /// <summary>Wall time by which controller time at a finite speed may lead or lag the wall clock, because waits are shorter than the resolution of the
    /// computer's timers.</summary>
    private static readonly TimeSpan WallLeeway = TimeSpan.FromMilliseconds(20);

    /// <summary>Wall time of silence after which a host with the clock that waits for a missing answer is assumed to be waiting for its own time-out.</summary>
    private static readonly TimeSpan UnansweredTimeout = TimeSpan.FromMilliseconds(500);

    /// <summary>Wall time of silence after which a host in another process is considered lost: time passes without it, and a watchdog can detect the loss. A
    /// host in this process is late only when this process is late, and is waited for unless it waits for bytes that do not come, as after a reply that was
    /// damaged on the way.</summary>
    private static readonly TimeSpan LostHostTimeout = TimeSpan.FromSeconds(10);

    private readonly SilenceRule _silence = new(machine, options.Time);
    private readonly long _started = options.Time.GetTimestamp();
    private TimeSpan _paced;
    private TimeSpan _credit;

    public HostClocks Hosts { get; } = new();

    /// <summary>Wall time since the controller was switched on.</summary>
    public TimeSpan Wall => options.Time.GetElapsedTime(_started);

    /// <summary>True when controller time follows the wall clock; false when it is virtual or a host has the clock, so that it is advanced by
    /// <see cref="Spend"/>.</summary>
    public bool FollowsWall => !options.IsVirtual && !Hosts.HasHosts;

    /// <summary>Advances controller time by the duration of a command or a byte, unless time follows the wall clock.</summary>
    public void Spend(TimeSpan cost)
    {
        if (FollowsWall) return;
        machine.Advance(cost);
        _credit -= cost;
    }

    /// <summary>Called when a host has connected, disconnected or sent something.</summary>
    public void ByteReceived() => _silence.ByteReceived();

    /// <summary>Advances controller time to the wall clock when it follows the wall clock. At a speed above 1, computing time does not count: a busy computer
    /// makes the
    /// controller slower instead of letting it lag further and further behind its host.</summary>
    public void Pace()
    {
        var now = Wall;
        var elapsed = now - _paced;
        if (Hosts.HasHosts) PaceHosts(elapsed);
        else if (!options.IsVirtual) machine.Advance(elapsed * options.Speed);
        _paced = options.Speed > 1.0 ? Wall : now;
    }

    /// <summary>Called every few milliseconds while an event is possible: advances time after silence, or when a host is stuck.</summary>
    /// <param name="isHeldUp">True when a host waits for an answer that the controller does not send, or has sent an incomplete command.</param>
    /// <param name="isRead">True when a client is currently waiting for bytes from the controller. This distinguishes a host in this process that waits for an
    /// answer from one that is late.</param>
    public void Poll(bool isHeldUp, bool isRead)
    {
        if (!Hosts.HasHosts)
        {
            if (options.IsVirtual) _silence.Poll();
            return;
        }

        if (!Hosts.AllWait && Hosts.All(host => host.IsWaiting || IsStuck(host, isHeldUp, isRead))) machine.Advance(SincePoll());
        _lastPoll = Wall;
    }

    /// <summary>Advances time towards the first host timer while all hosts wait.</summary>
    /// <returns>False when a host is working, or when controller time is ahead of the wall clock clock.</returns>
    public bool PassTowardsNext()
    {
        if (!Hosts.AllWait) return false;
        var step = Math.Clamp(Hosts.NextDue - machine.ClockTicks, 0, LongestStep);
        if (!options.IsVirtual) step = Math.Min(step, (_credit + Leeway).Ticks);
        if (step < 0) return false; // controller time is ahead of the wall clock
        machine.Advance(TimeSpan.FromTicks(step));
        _credit -= TimeSpan.FromTicks(step);
        return step > 0 || Hosts.NextDue <= machine.ClockTicks;
    }

    private bool IsStuck(HostClock host, bool isHeldUp, bool isRead) =>
        (host.IsElsewhere || isRead) && _silence.Silent >= (isHeldUp ? UnansweredTimeout : LostHostTimeout);

    private TimeSpan _lastPoll;

    private TimeSpan Leeway => WallLeeway * options.Speed;

    private TimeSpan SincePoll() => Wall - _lastPoll is var gap && gap < UnansweredTimeout ? gap : TimeSpan.Zero;

    /// <summary>At a finite speed, waiting hosts cannot run ahead of the wall clock; wall time that passes while a host is working is not made up
    /// for.</summary>
    private void PaceHosts(TimeSpan elapsed)
    {
        if (options.IsVirtual) return;
        _credit += elapsed * options.Speed;
        if (_credit > Leeway) _credit = Leeway;
        PassTowardsNext();
    }
}
