namespace Engraver.Simulator.Clocks;

/// <summary>How the controller's time goes on: by its hosts' leave where one has the clock, else with the wall, else (speed max) by commands and silence. All members are called under the controller's lock.</summary>
internal sealed class ControllerClock(Machine machine, SimulatorOptions options)
{
    /// <summary>A wait of a host lets so much time pass before anybody else gets the lock.</summary>
    private const long LongestStep = TimeSpan.TicksPerSecond;

    /// <summary>By so much of the wall's time a finite speed may be ahead of the wall or behind it: waits are shorter than a timer of the computer is exact.</summary>
    private static readonly TimeSpan WallLeeway = TimeSpan.FromMilliseconds(20);

    /// <summary>A host that has the clock and is silent so long, while it waits for an answer that does not come, waits for its own time-out.</summary>
    private static readonly TimeSpan Unanswered = TimeSpan.FromMilliseconds(500);

    /// <summary>And one that says nothing at all for so long is given up: time goes on without it, and a watchdog finds it dead.</summary>
    private static readonly TimeSpan GivenUp = TimeSpan.FromSeconds(10);

    private readonly SilenceRule _silence = new(machine, options.Time);
    private readonly long _started = options.Time.GetTimestamp();
    private TimeSpan _paced;
    private TimeSpan _credit;

    public HostClocks Hosts { get; } = new();

    /// <summary>Wall time since the controller was switched on.</summary>
    public TimeSpan Wall => options.Time.GetElapsedTime(_started);

    /// <summary>A command or a byte takes its time, but only where time does not follow the wall.</summary>
    public void Spend(TimeSpan cost)
    {
        if (!options.IsVirtual && !Hosts.AreThere) return;
        machine.Advance(cost);
        _credit -= cost;
    }

    /// <summary>A host came, went or said something.</summary>
    public void Heard() => _silence.Heard();

    /// <summary>Brings the controller up to the wall, as far as it follows it. Where it is to run ahead of the wall, the time that the computing takes does not count: a busy computer makes the
    /// controller slower instead of letting it fall behind its host for ever.</summary>
    public void Pace()
    {
        var now = Wall;
        var elapsed = now - _paced;
        if (Hosts.AreThere) PaceHosts(elapsed);
        else if (!options.IsVirtual) machine.Advance(elapsed * options.Speed);
        _paced = options.Speed > 1.0 ? Wall : now;
    }

    /// <summary>Every few milliseconds while something can happen.</summary>
    /// <param name="isHeldUp">A host waits for an answer that the controller does not give, or has said half a command.</param>
    public void Look(bool isHeldUp)
    {
        if (!Hosts.AreThere)
        {
            if (options.IsVirtual) _silence.Look();
            return;
        }

        var isStuck = _silence.Silent >= (isHeldUp ? Unanswered : GivenUp);
        if (isStuck && !Hosts.AllWait) machine.Advance(SinceLook());
        _looked = Wall;
    }

    /// <summary>Lets time pass towards the first timer of a host, while all of them wait.</summary>
    /// <returns>False when a host is at work, or the wall has to come up first.</returns>
    public bool PassTowardsNext()
    {
        if (!Hosts.AllWait) return false;
        var step = Math.Clamp(Hosts.NextDue - machine.ClockTicks, 0, LongestStep);
        if (!options.IsVirtual) step = Math.Min(step, (_credit + Leeway).Ticks);
        if (step < 0) return false; // the wall has to come up first
        machine.Advance(TimeSpan.FromTicks(step));
        _credit -= TimeSpan.FromTicks(step);
        return step > 0 || Hosts.NextDue <= machine.ClockTicks;
    }

    private TimeSpan _looked;

    private TimeSpan Leeway => WallLeeway * options.Speed;

    private TimeSpan SinceLook() => Wall - _looked is var gap && gap < Unanswered ? gap : TimeSpan.Zero;

    /// <summary>A finite speed holds hosts that wait back to the wall; what passes while one is at work is not caught up with.</summary>
    private void PaceHosts(TimeSpan elapsed)
    {
        if (options.IsVirtual) return;
        _credit += elapsed * options.Speed;
        if (_credit > Leeway) _credit = Leeway;
        PassTowardsNext();
    }
}
