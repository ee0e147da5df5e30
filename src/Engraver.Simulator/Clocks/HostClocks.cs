namespace Engraver.Simulator.Clocks;

/// <summary>The hosts that have the controller's clock, and their timers. All members are called under the controller's lock.</summary>
internal sealed class HostClocks
{
    private readonly List<HostClock> _hosts = [];
    private readonly List<HostTimer> _set = [];
    private long _started;

    /// <summary>At least one host has the clock: time passes only while the hosts wait or send commands.</summary>
    public bool HasHosts => _hosts.Count > 0;

    /// <summary>Every host waits for one of its timers.</summary>
    public bool AllWait => All(static host => host.IsWaiting);

    /// <summary>Time at which the first timer fires, ticks; <see cref="long.MaxValue"/> when no timer is set.</summary>
    public long NextDue
    {
        get
        {
            var next = long.MaxValue;
            foreach (var timer in _set) next = Math.Min(next, timer.Due);
            return next;
        }
    }

    public bool All(Predicate<HostClock> condition) => _hosts.TrueForAll(condition);

    public void Add(HostClock host) => _hosts.Add(host);

    /// <summary>Removes a host and its timers, which no longer fire.</summary>
    public void Remove(HostClock host)
    {
        _hosts.Remove(host);
        _set.RemoveAll(timer => timer.Host == host);
    }

    /// <param name="due">Ticks of controller time; <see cref="long.MaxValue"/> stops the timer.</param>
    public void Set(HostTimer timer, long due, long period, bool isWait)
    {
        // A wait that is cancelled early leaves the host working, unless it has started another wait in the meantime.
        if (timer.IsWait && !isWait) timer.Host.IsWaiting = _set.Exists(other => other.Host == timer.Host && other.IsWait && other.Started > timer.Started);
        if (isWait) timer.Started = ++_started;
        (timer.Due, timer.Period, timer.IsWait) = (due, period, isWait);
        _set.Remove(timer);
        if (due == long.MaxValue || !_hosts.Contains(timer.Host)) return;
        if (isWait) timer.Host.IsWaiting = true;
        _set.Add(timer);
    }

    /// <summary>Takes the first timer that is due; its host counts as working from now on if it waited for this timer. Null when no timer is due.</summary>
    public HostTimer? TakeDue(long now)
    {
        HostTimer? first = null;
        foreach (var timer in _set)
        {
            if (timer.Due <= now && (first is null || timer.Due < first.Due)) first = timer;
        }

        if (first is null) return null;
        if (first.IsWait) first.Host.IsWaiting = false;
        first.IsWait = false;
        first.Due = first.Period > 0 ? first.Due + first.Period : long.MaxValue;
        if (first.Due == long.MaxValue) _set.Remove(first);
        return first;
    }
}
