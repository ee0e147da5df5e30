namespace Engraver.Simulator.Clocks;

/// <summary>Serves the hosts that have the controller's clock. All members may be called from any thread.</summary>
/// <param name="gate">The controller's lock.</param>
/// <param name="happened">Called under the lock when time has passed or can pass.</param>
/// <param name="flush">Called without the lock after time has passed, to write the record's file.</param>
internal sealed class HostClockCoordinator(Machine machine, ControllerClock clock, Lock gate, Action happened, Action flush)
{
    /// <summary>The controller's time in ticks of 100 ns.</summary>
    public long Now
    {
        get
        {
            lock (gate)
            {
                clock.Pace();
                return machine.ClockTicks;
            }
        }
    }

    /// <summary>Assigns the clock to a host.</summary>
    /// <param name="isElsewhere">The host is another process.</param>
    public HostClock Join(bool isElsewhere)
    {
        var host = new HostClock(this, isElsewhere);
        lock (gate)
        {
            clock.Pace();
            clock.Hosts.Add(host);
            clock.ByteReceived();
            happened();
        }

        return host;
    }

    /// <summary>Takes the clock back from a host.</summary>
    public void Leave(HostClock host)
    {
        lock (gate)
        {
            clock.Pace();
            clock.Hosts.Remove(host);
            clock.ByteReceived();
            happened();
        }

        FireDue();
    }

    public void Set(HostTimer timer, TimeSpan due, TimeSpan period, bool isWait)
    {
        lock (gate)
        {
            if (isWait) clock.ByteReceived();
            clock.Hosts.Set(
                timer, due == Timeout.InfiniteTimeSpan ? long.MaxValue : machine.ClockTicks + due.Ticks, period == Timeout.InfiniteTimeSpan ? 0 : period.Ticks, isWait);
            happened();
        }
    }

    /// <summary>Advances time on the thread of the waiting host: to the end of its wait, until another host is working or, at a finite speed, until controller
    /// time is ahead of the wall clock. The controller's timer then advances the rest.</summary>
    /// <param name="own">The wait; it fires in this thread.</param>
    public void PassWhileAllWait(HostTimer own)
    {
        while (true)
        {
            HostTimer? due;
            lock (gate)
            {
                if (own.Due == long.MaxValue || !clock.PassTowardsNext()) return;
                due = clock.Hosts.TakeDue(machine.ClockTicks);
                happened();
            }

            flush();
            if (due == own)
            {
                own.Fire();
                return;
            }

            Queue(due);
        }
    }

    /// <summary>Fires the timers that controller time has reached.</summary>
    public void FireDue()
    {
        while (true)
        {
            HostTimer? due;
            lock (gate)
            {
                due = clock.Hosts.TakeDue(machine.ClockTicks);
            }

            if (due is null) return;
            Queue(due);
        }
    }

    private static void Queue(HostTimer? due)
    {
        if (due is not null) ThreadPool.UnsafeQueueUserWorkItem(static timer => timer.Fire(), due, preferLocal: false);
    }
}
