using Engraver.Simulator.Clocks;
using Engraver.Simulator.Protocol;

namespace Engraver.Simulator;

/// <summary>Brings commands, wall time and controller time together under one lock.</summary>
internal sealed class ControllerCore : IDisposable
{
    private static readonly TimeSpan ShortestTick = TimeSpan.FromMilliseconds(2);
    private static readonly TimeSpan LongestTick = TimeSpan.FromHours(1);

    /// <summary>At speed max hosts that have the clock let time pass; now and then it is seen whether one of them is stuck.</summary>
    private static readonly TimeSpan HostTick = TimeSpan.FromMilliseconds(100);

    private readonly Lock _gate = new();
    private readonly SimulatorOptions _options;
    private readonly ITimer _timer;
    private readonly ControllerClock _clock;
    private readonly CommandDesk _desk;
    private readonly StatusBoard _status;
    private readonly RecordFile _recordFile;
    private TimeSpan _nextTick = TimeSpan.MaxValue;

    public ControllerCore(SimulatorOptions options)
    {
        _options = options;
        Machine = new Machine(options);
        _clock = new ControllerClock(Machine, options);
        _status = new StatusBoard(Machine);
        _recordFile = new RecordFile(Machine.Record);
        _desk = new CommandDesk(Machine, _clock, options);
        _timer = options.Time.CreateTimer(_ => Tick(), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
    }

    public Machine Machine { get; }

    /// <summary>What stopped the record file from being written; null while all is well.</summary>
    public IOException? RecordFailure => _recordFile.Failure;

    public ControllerStatus Status
    {
        get
        {
            lock (_gate)
            {
                _clock.Pace();
                return _status.Now();
            }
        }
    }

    /// <param name="datagrams">Where the answers of a UDP handle go; null for a connection.</param>
    public Handle? Open(int localPort, int remotePort, Action? disconnect, DatagramSender? datagrams = null)
    {
        lock (_gate)
        {
            _clock.Pace();
            _clock.Heard();
            return Machine.Handles.TryOpen(i => new Handle(i, localPort, remotePort == 0 ? 1024 + i : remotePort, _desk) { Disconnect = disconnect, Datagrams = datagrams });
        }
    }

    /// <summary>Plugs a cable into the serial port; null when one is plugged in.</summary>
    public Handle? OpenSerial(int baud, Action? disconnect)
    {
        lock (_gate)
        {
            _clock.Pace();
            _clock.Heard();
            return Machine.Serial.Plug(baud, new Handle(SerialPort.HandleIndex, 0, 0, _desk) { Disconnect = disconnect });
        }
    }

    public void Receive(Handle handle, ReadOnlySpan<byte> bytes)
    {
        lock (_gate)
        {
            _clock.Pace();
            handle.Receive(bytes);
            _clock.Heard();
            _status.Notify();
            TickWithin(TickPeriod);
        }

        FireDue();
    }

    /// <summary>The controller's time in ticks of 100 ns.</summary>
    public long ClockTicks
    {
        get
        {
            lock (_gate)
            {
                _clock.Pace();
                return Machine.ClockTicks;
            }
        }
    }

    /// <summary>Gives a host the clock.</summary>
    public HostClock Join()
    {
        lock (_gate)
        {
            _clock.Pace();
            _clock.Heard();
            var host = new HostClock(this);
            _clock.Hosts.Add(host);
            TickWithin(TickPeriod);
            return host;
        }
    }

    /// <summary>A host gives the clock back, or is gone.</summary>
    public void Leave(HostClock host)
    {
        lock (_gate)
        {
            _clock.Pace();
            _clock.Hosts.Remove(host);
            _clock.Heard();
            _status.Notify();
            TickWithin(TickPeriod);
        }

        FireDue();
    }

    public void Set(HostTimer timer, TimeSpan due, TimeSpan period, bool isWait)
    {
        lock (_gate)
        {
            if (isWait) _clock.Heard();
            _clock.Hosts.Set(
                timer, due == Timeout.InfiniteTimeSpan ? long.MaxValue : Machine.ClockTicks + due.Ticks, period == Timeout.InfiniteTimeSpan ? 0 : period.Ticks, isWait);
            TickWithin(TickPeriod);
        }
    }

    /// <summary>At speed max: lets time pass in the thread of the host that waits, to the end of its wait or until another host has something to do.</summary>
    /// <param name="own">The wait; it fires in this thread.</param>
    public void PassWhileAllWait(HostTimer own)
    {
        if (!_options.IsVirtual) return; // Tick lets it pass, with the wall
        while (true)
        {
            HostTimer? due;
            lock (_gate)
            {
                if (own.Due == long.MaxValue || !_clock.PassTowardsNext()) return;
                due = _clock.Hosts.TakeDue(Machine.ClockTicks);
                _status.Notify();
            }

            _recordFile.Flush();
            if (due == own)
            {
                own.Fire();
                return;
            }

            if (due is not null) ThreadPool.UnsafeQueueUserWorkItem(static timer => timer.Fire(), due, preferLocal: false);
        }
    }

    /// <summary>The client went away: its handle is free again, motion and threads go on.</summary>
    public void Detach(Handle handle)
    {
        lock (_gate)
        {
            handle.Close();
            _clock.Heard();
            _status.Notify();
            TickWithin(TickPeriod);
        }
    }

    public void CutAll()
    {
        lock (_gate)
        {
            foreach (var handle in Machine.Handles.Open.ToArray()) handle.Cut();

            Machine.Serial.Client?.Cut();
            _status.Notify();
        }
    }

    public void With(Action<Machine> action)
    {
        lock (_gate)
        {
            _clock.Pace();
            action(Machine);
            _status.Notify();
            TickWithin(TickPeriod);
        }
    }

    public void Advance(TimeSpan time)
    {
        lock (_gate)
        {
            Machine.Advance(time);
            _status.Notify();
            TickWithin(TickPeriod);
        }

        FireDue();
    }

    public bool AdvanceUntil(Func<ControllerStatus, bool> condition, TimeSpan atMost)
    {
        lock (_gate)
        {
            for (var end = Machine.Sample + (long)atMost.TotalMilliseconds; !condition(_status.Now());)
            {
                if (Machine.Sample >= end) return false;

                Machine.Advance(TimeSpan.FromMilliseconds(1));
            }

            _status.Notify();
            return true;
        }
    }

    public async Task<ControllerStatus> WaitUntilAsync(Func<ControllerStatus, bool> condition, CancellationToken cancellation)
    {
        var waiter = new StatusWaiter(condition);
        lock (_gate)
        {
            _status.Add(waiter);
            _clock.Pace();
            _status.Notify();
            TickWithin(TickPeriod);
        }

        try
        {
            return await waiter.Task.WaitAsync(cancellation).ConfigureAwait(false);
        }
        finally
        {
            lock (_gate)
            {
                _status.Remove(waiter);
            }
        }
    }

    public void Dispose()
    {
        CutAll();
        _timer.Dispose();
        _recordFile.Flush();
    }

    private TimeSpan TickPeriod => !_options.IsVirtual ? ShortestTick : _clock.Hosts.AreThere ? HostTick : SilenceRule.Short;

    /// <summary>How long nothing can happen of itself. An idle controller takes no processor time at all: the next command wakes it, and catches up with the wall.</summary>
    private TimeSpan QuietTime()
    {
        if (_status.IsAwaited || _desk.HasLateReplies || _clock.Hosts.AreThere) return TickPeriod;
        if (Machine.IsDormant) return Timeout.InfiniteTimeSpan;
        if (_options.IsVirtual || Machine.Motion.CanProgress) return TickPeriod;
        var milliseconds = (Machine.QuietUntil - Machine.Sample) / _options.Speed;
        return TimeSpan.FromMilliseconds(Math.Clamp(milliseconds, ShortestTick.TotalMilliseconds, LongestTick.TotalMilliseconds));
    }

    /// <summary>Wakes the controller so soon; one that is to wake sooner already does.</summary>
    private void TickWithin(TimeSpan delay)
    {
        if (delay == Timeout.InfiniteTimeSpan) return;
        var due = _clock.Wall + delay;
        if (due >= _nextTick) return;
        _nextTick = due;
        _timer.Change(delay, Timeout.InfiniteTimeSpan);
    }

    private void Tick()
    {
        lock (_gate)
        {
            _nextTick = TimeSpan.MaxValue;
            _clock.Pace();
            _desk.ReleaseReplies();
            _clock.Look(_desk.IsFrozen || _desk.HasLateReplies || Machine.Handles.Open.Any(static handle => handle.IsMidCommand));

            _status.Notify();
            TickWithin(QuietTime());
        }

        FireDue();
        _recordFile.Flush();
    }

    private void FireDue()
    {
        while (true)
        {
            HostTimer? due;
            lock (_gate)
            {
                if (!_clock.Hosts.AreThere) return;
                due = _clock.Hosts.TakeDue(Machine.ClockTicks);
            }

            if (due is null) return;
            ThreadPool.UnsafeQueueUserWorkItem(static timer => timer.Fire(), due, preferLocal: false);
        }
    }
}
