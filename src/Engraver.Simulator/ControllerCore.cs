using Engraver.Simulator.Clocks;
using Engraver.Simulator.Protocol;

namespace Engraver.Simulator;

/// <summary>Serialises commands, wall time and controller time under one lock.</summary>
internal sealed class ControllerCore : IDisposable
{
    private static readonly TimeSpan ShortestTick = TimeSpan.FromMilliseconds(2);
    private static readonly TimeSpan LongestTick = TimeSpan.FromHours(1);

    /// <summary>Period of <see cref="Tick"/> at speed max while hosts have the clock and advance time themselves: it only checks for a stuck host.</summary>
    private static readonly TimeSpan HostTick = TimeSpan.FromMilliseconds(100);

    private readonly Lock _gate = new();
    private readonly SimulatorOptions _options;
    private readonly ITimer _timer;
    private readonly ControllerClock _clock;
    private readonly CommandDispatcher _dispatcher;
    private readonly StatusModel _status;
    private readonly RecordFile _recordFile;
    private readonly TaskCompletionSource _broken = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private TimeSpan _nextTick = TimeSpan.MaxValue;

    public ControllerCore(SimulatorOptions options)
    {
        _options = options;
        Machine = new Machine(options);
        _clock = new ControllerClock(Machine, options);
        _status = new StatusModel(Machine);
        _recordFile = new RecordFile(Machine.Record);
        _dispatcher = new CommandDispatcher(Machine, _clock, options);
        Hosts = new HostClockCoordinator(Machine, _clock, _gate, OnMachineChanged, _recordFile.Flush);
        _timer = options.Time.CreateTimer(_ => Tick(), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
    }

    public Machine Machine { get; }

    /// <summary>The hosts that run in step with the controller.</summary>
    public HostClockCoordinator Hosts { get; }

    /// <summary>Faults with the exception (an internal error of the simulator) that stopped the controller; never completes otherwise.</summary>
    public Task Broken => _broken.Task;

    /// <summary>The error that stopped writing the record file; null while writing succeeds.</summary>
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

    /// <param name="datagrams">Receives the answers of a UDP handle; null for a connection.</param>
    public Handle? Open(int localPort, int remotePort, Action? disconnect, SendDatagram? datagrams = null)
    {
        lock (_gate)
        {
            _clock.Pace();
            _clock.ByteReceived();
            return Machine.Handles.TryOpen(i => new Handle(i, localPort, remotePort == 0 ? 1024 + i : remotePort, _dispatcher) { Disconnect = disconnect, Datagrams = datagrams });
        }
    }

    /// <summary>Connects a cable to the serial port; returns null when one is already connected.</summary>
    public Handle? OpenSerial(int baud, Action? disconnect)
    {
        lock (_gate)
        {
            _clock.Pace();
            _clock.ByteReceived();
            return Machine.Serial.Plug(baud, new Handle(SerialPort.HandleIndex, 0, 0, _dispatcher) { Disconnect = disconnect });
        }
    }

    /// <summary>Takes bytes that a client sent. An internal error that occurs here stops the controller, not the thread that carries the bytes.</summary>
    /// <param name="taken">Called with the controller's clock before the bytes are executed; null for no callback.</param>
    public void Receive(Handle handle, ReadOnlySpan<byte> bytes, Action<long>? taken = null)
    {
        lock (_gate)
        {
            try
            {
                _clock.Pace();
                _dispatcher.ReleaseCommands();
                taken?.Invoke(Machine.ClockTicks);
                handle.Receive(bytes);
                _clock.ByteReceived();
                OnMachineChanged();
            }
            catch (Exception bug)
            {
                Break(bug);
            }
        }

        Hosts.FireDue();
    }

    /// <summary>Awaits a task that serves clients; an exception in it stops the controller like an exception of the controller itself.</summary>
    public async Task WatchAsync(Task serving)
    {
        try
        {
            await serving.ConfigureAwait(false);
        }
        catch (Exception bug)
        {
            lock (_gate)
            {
                Break(bug);
            }
        }

        Hosts.FireDue();
    }

    /// <summary>Called when the client has disconnected: its handle is free again; motion and threads continue.</summary>
    public void Detach(Handle handle)
    {
        lock (_gate)
        {
            handle.Close();
            _clock.ByteReceived();
            OnMachineChanged();
        }
    }

    public void CutAll()
    {
        lock (_gate)
        {
            Machine.CutLinks();
            _status.Notify();
        }
    }

    public void With(Action<Machine> action)
    {
        lock (_gate)
        {
            _clock.Pace();
            action(Machine);
            OnMachineChanged();
        }
    }

    public void Advance(TimeSpan time)
    {
        lock (_gate)
        {
            Machine.Advance(time);
            OnMachineChanged();
        }

        Hosts.FireDue();
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

    public (ControllerStatus Status, bool HasRested) AdvanceToRest(long atMost, long longestRest, int steps)
    {
        lock (_gate)
        {
            var hasRested = Machine.AdvanceToRest(atMost, longestRest, steps);
            _status.Notify();
            TickWithin(TickPeriod);
            return (_status.Now(), hasRested);
        }
    }

    public async Task<ControllerStatus> WaitUntilAsync(Func<ControllerStatus, bool> condition, CancellationToken cancellation)
    {
        var waiter = new StatusWaiter(condition);
        lock (_gate)
        {
            _status.Add(waiter);
            _clock.Pace();
            OnMachineChanged();
        }

        try
        {
            await Task.WhenAny(waiter.Task, Broken).WaitAsync(cancellation).ConfigureAwait(false);
            if (!waiter.Task.IsCompleted) await Broken.ConfigureAwait(false);
            return await waiter.Task.ConfigureAwait(false);
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
        _timer.Dispose(); // a tick that is already running continues in parallel
        _recordFile.Complete();
    }

    private TimeSpan TickPeriod =>
        _options.IsVirtual ? _clock.Hosts.HasHosts ? HostTick : SilenceRule.Short
        : _dispatcher.DecodeRemaining is { } rest && rest < ShortestTick ? TimerWait(rest)
        : ShortestTick;

    /// <summary>A wait of at least one millisecond and of whole milliseconds, as the computer's timers count; a timer would shorten any other.</summary>
    private static TimeSpan TimerWait(TimeSpan wait) => TimeSpan.FromMilliseconds(Math.Max(1.0, Math.Ceiling(wait.TotalMilliseconds)));

    /// <summary>Wall time until the next event that needs no command. Infinite when idle: then no processor time is used, and the next command wakes the
    /// controller and advances it to the wall clock.</summary>
    private TimeSpan TimeWithoutEvents()
    {
        if (_status.IsAwaited || _dispatcher.HasLateReplies || _dispatcher.DecodeRemaining is not null || _clock.Hosts.HasHosts) return TickPeriod;
        if (Machine.IsDormant) return Timeout.InfiniteTimeSpan;
        if (_options.IsVirtual || Machine.Motion.CanProgress) return TickPeriod;
        var milliseconds = (Machine.QuietUntil - Machine.Sample) / _options.Speed;
        return TimeSpan.FromMilliseconds(Math.Clamp(milliseconds, ShortestTick.TotalMilliseconds, LongestTick.TotalMilliseconds));
    }

    /// <summary>Sets the timer to fire within <paramref name="delay"/>; a timer that is due sooner stays as it is.</summary>
    private void TickWithin(TimeSpan delay)
    {
        if (delay == Timeout.InfiniteTimeSpan) return;
        var due = _clock.Wall + delay;
        if (due >= _nextTick) return;
        _nextTick = due;
        _timer.Change(delay, Timeout.InfiniteTimeSpan);
    }

    /// <summary>Runs on a timer thread: an exception that is not caught here would end the process.</summary>
    private void Tick()
    {
        lock (_gate)
        {
            if (_broken.Task.IsCompleted) return;
            try
            {
                PassTime();
            }
            catch (Exception bug)
            {
                Break(bug);
            }
        }

        Hosts.FireDue();
        _recordFile.Flush();
    }

    private void PassTime()
    {
        _nextTick = TimeSpan.MaxValue;
        _clock.Pace();
        _dispatcher.ReleaseCommands();
        _dispatcher.ReleaseReplies();
        PollHosts();

        _status.Notify();
        TickWithin(TimeWithoutEvents());
    }

    private void PollHosts()
    {
        var isHeldUp = _dispatcher.IsFrozen || _dispatcher.HasLateReplies || Machine.Faults.IsReplyPending || Machine.Handles.Open.Any(static handle => handle.IsMidCommand);
        _clock.Poll(isHeldUp, Machine.Handles.Open.Any(static handle => handle.Output.IsRead) || Machine.Serial.Client?.Output.IsRead == true);
    }

    /// <summary>Stops the controller after an internal error of the simulator, because its state can no longer be trusted. Disconnects every client, so that
    /// clients do not wait for an answer, and faults <see cref="Broken"/>.</summary>
    private void Break(Exception bug)
    {
        if (!_broken.TrySetException(new InvalidOperationException($"the simulated controller failed ({bug.GetType().Name}: {bug.Message}); every client was cut off", bug))) return;
        _ = _broken.Task.Exception; // marks the exception as observed: an owner that never awaits Broken causes no UnobservedTaskException
        Machine.CutLinks();
    }

    private void OnMachineChanged()
    {
        _status.Notify();
        TickWithin(TickPeriod);
    }
}
