namespace Engraver.Simulator.Clocks;

/// <summary>The hosts that have the controller's clock, and their timers. All members are called under the controller's lock.</summary>
internal sealed class HostClocks
{
    private readonly List<HostClock> _hosts = [];
    private readonly List<HostTimer> _set = [];

    /// <summary>A host has the clock: time is the hosts' to let go on.</summary>
    public bool AreThere => _hosts.Count > 0;

    /// <summary>No host has anything left to do before its timers fire.</summary>
    public bool AllWait => _hosts.TrueForAll(static host => host.IsWaiting);

    /// <summary>When the first timer fires, ticks; <see cref="long.MaxValue"/> when none is set.</summary>
    public long NextDue
    {
        get
        {
            var next = long.MaxValue;
            foreach (var timer in _set) next = Math.Min(next, timer.Due);
            return next;
        }
    }

    public void Add(HostClock host) => _hosts.Add(host);

    /// <summary>Its timers will not fire any more.</summary>
    public void Remove(HostClock host)
    {
        _hosts.Remove(host);
        _set.RemoveAll(timer => timer.Host == host);
    }

    /// <param name="due">Ticks of the controller; <see cref="long.MaxValue"/> lays the timer to rest.</param>
    public void Set(HostTimer timer, long due, long period, bool isWait)
    {
        // A wait that is ended early, by a cancellation, leaves the host at work.
        if (timer.IsWait && !isWait) timer.Host.IsWaiting = false;
        (timer.Due, timer.Period, timer.IsWait) = (due, period, isWait);
        _set.Remove(timer);
        if (due == long.MaxValue || !_hosts.Contains(timer.Host)) return;
        if (isWait) timer.Host.IsWaiting = true;
        _set.Add(timer);
    }

    /// <summary>Takes the first timer that is due; its host is at work from now on when it waited for it. Null when none is due.</summary>
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
