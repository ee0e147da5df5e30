namespace Engraver.Simulator.Clocks;

/// <summary>Decides when controller time passes: while hosts have the clock, only as they wait and send commands; otherwise with the wall; otherwise (speed max) by commands and silence. All members are called under the controller's lock.</summary>
internal sealed class ControllerClock(Machine machine, SimulatorOptions options)
{
    /// <summary>Controller time that one wait of a host lets pass before another thread can take the lock.</summary>
    private const long LongestStep = TimeSpan.TicksPerSecond;

    /// <summary>Wall time by which a finite speed may be ahead of the wall or behind it, because waits are shorter than the resolution of the computer's timers.</summary>
    private static readonly TimeSpan WallLeeway = TimeSpan.FromMilliseconds(20);

    /// <summary>Wall time of silence after which a host with the clock that waits for an answer which does not come is taken to be waiting for its own time-out.</summary>
    private static readonly TimeSpan Unanswered = TimeSpan.FromMilliseconds(500);

    /// <summary>Wall time of silence after which a host of another process is given up: time passes without it, and a watchdog finds it dead. A host of this process is waited for without end, because it is late only where this process is.</summary>
    private static readonly TimeSpan GivenUp = TimeSpan.FromSeconds(10);

    private readonly SilenceRule _silence = new(machine, options.Time);
    private readonly long _started = options.Time.GetTimestamp();
    private TimeSpan _paced;
    private TimeSpan _credit;

    public HostClocks Hosts { get; } = new();

    /// <summary>Wall time since the controller was switched on.</summary>
    public TimeSpan Wall => options.Time.GetElapsedTime(_started);

    /// <summary>Lets the time of a command or of a byte pass, unless time follows the wall.</summary>
    public void Spend(TimeSpan cost)
    {
        if (!options.IsVirtual && !Hosts.AreThere) return;
        machine.Advance(cost);
        _credit -= cost;
    }

    /// <summary>Called when a host has connected, disconnected or sent something.</summary>
    public void Heard() => _silence.Heard();

    /// <summary>Brings controller time up to the wall where it follows the wall. At a speed above 1 the time that computing takes does not count: a busy computer makes the
    /// controller slower instead of letting it fall further and further behind its host.</summary>
    public void Pace()
    {
        var now = Wall;
        var elapsed = now - _paced;
        if (Hosts.AreThere) PaceHosts(elapsed);
        else if (!options.IsVirtual) machine.Advance(elapsed * options.Speed);
        _paced = options.Speed > 1.0 ? Wall : now;
    }

    /// <summary>Called every few milliseconds while something can happen: lets time pass after silence, or past a host that is stuck.</summary>
    /// <param name="isHeldUp">A host waits for an answer that the controller does not give, or has sent half a command.</param>
    /// <param name="isRead">Somebody waits for bytes of the controller at this moment: only so can it be told that a host of this process waits for an answer and is not merely late.</param>
    public void Look(bool isHeldUp, bool isRead)
    {
        if (!Hosts.AreThere)
        {
            if (options.IsVirtual) _silence.Look();
            return;
        }

        if (!Hosts.AllWait && Hosts.All(host => host.IsWaiting || IsStuck(host, isHeldUp, isRead))) machine.Advance(SinceLook());
        _looked = Wall;
    }

    /// <summary>Lets time pass towards the first timer of a host, while all of them wait.</summary>
    /// <returns>False when a host is at work, or when controller time is ahead of the wall.</returns>
    public bool PassTowardsNext()
    {
        if (!Hosts.AllWait) return false;
        var step = Math.Clamp(Hosts.NextDue - machine.ClockTicks, 0, LongestStep);
        if (!options.IsVirtual) step = Math.Min(step, (_credit + Leeway).Ticks);
        if (step < 0) return false; // controller time is ahead of the wall
        machine.Advance(TimeSpan.FromTicks(step));
        _credit -= TimeSpan.FromTicks(step);
        return step > 0 || Hosts.NextDue <= machine.ClockTicks;
    }

    private bool IsStuck(HostClock host, bool isHeldUp, bool isRead) =>
        host.IsElsewhere ? _silence.Silent >= (isHeldUp ? Unanswered : GivenUp) : isHeldUp && isRead && _silence.Silent >= Unanswered;

    private TimeSpan _looked;

    private TimeSpan Leeway => WallLeeway * options.Speed;

    private TimeSpan SinceLook() => Wall - _looked is var gap && gap < Unanswered ? gap : TimeSpan.Zero;

    /// <summary>At a finite speed, hosts that wait may not run ahead of the wall; wall time that passes while a host is at work is not made up for.</summary>
    private void PaceHosts(TimeSpan elapsed)
    {
        if (options.IsVirtual) return;
        _credit += elapsed * options.Speed;
        if (_credit > Leeway) _credit = Leeway;
        PassTowardsNext();
    }
}
