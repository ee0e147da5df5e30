using Engraver.Simulator.Protocol;

namespace Engraver.Simulator;

/// <summary>Brings commands, wall time and controller time together under one lock.</summary>
internal sealed class ControllerCore : IDisposable
{
    private static readonly TimeSpan ShortestTick = TimeSpan.FromMilliseconds(2);
    private static readonly TimeSpan LongestTick = TimeSpan.FromHours(1);

    private readonly Lock _gate = new();
    private readonly SimulatorOptions _options;
    private readonly ITimer _timer;
    private readonly long _started;
    private readonly SilenceWatch _silence;
    private readonly CommandDesk _desk;
    private readonly StatusBoard _status;
    private readonly RecordFile _recordFile;
    private readonly TaskCompletionSource _broken = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private TimeSpan _paced;
    private TimeSpan _nextTick = TimeSpan.MaxValue;

    public ControllerCore(SimulatorOptions options)
    {
        _options = options;
        Machine = new Machine(options);
        _started = options.Time.GetTimestamp();
        _status = new StatusBoard(Machine);
        _recordFile = new RecordFile(Machine.Record);
        _silence = new SilenceWatch(Machine, options.Time);
        _desk = new CommandDesk(Machine, options);
        _timer = options.Time.CreateTimer(_ => Tick(), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
    }

    public Machine Machine { get; }

    /// <summary>Faults with the bug that ended the controller's work.</summary>
    public Task Broken => _broken.Task;

    /// <summary>What stopped the record file from being written; null while all is well.</summary>
    public IOException? RecordFailure => _recordFile.Failure;

    public ControllerStatus Status
    {
        get
        {
            lock (_gate)
            {
                Pace();
                return _status.Now();
            }
        }
    }

    /// <param name="datagrams">Where the answers of a UDP handle go; null for a connection.</param>
    public Handle? Open(int localPort, int remotePort, Action? disconnect, DatagramSender? datagrams = null)
    {
        lock (_gate)
        {
            Pace();
            _silence.Heard(null);
            return Machine.Handles.TryOpen(i => new Handle(i, localPort, remotePort == 0 ? 1024 + i : remotePort, _desk) { Disconnect = disconnect, Datagrams = datagrams });
        }
    }

    /// <summary>Plugs a cable into the serial port; null when one is plugged in.</summary>
    public Handle? OpenSerial(int baud, Action? disconnect)
    {
        lock (_gate)
        {
            Pace();
            _silence.Heard(null);
            return Machine.Serial.Plug(baud, new Handle(SerialPort.HandleIndex, 0, 0, _desk) { Disconnect = disconnect });
        }
    }

    /// <summary>What a client sent. A bug that shows here breaks the controller, not the thread that carries the bytes.</summary>
    public void Receive(Handle handle, ReadOnlySpan<byte> bytes)
    {
        lock (_gate)
        {
            try
            {
                Pace();
                var asked = handle.Questions;
                handle.Receive(bytes);
                _silence.Heard(handle, handle.Questions - asked);
                _status.Notify();
                TickWithin(TickPeriod);
            }
            catch (Exception bug)
            {
                Break(bug);
            }
        }
    }

    /// <summary>Serves clients to the end; a bug there ends the controller's work like one of its own.</summary>
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
    }

    /// <summary>The client went away: its handle is free again, motion and threads go on.</summary>
    public void Detach(Handle handle)
    {
        lock (_gate)
        {
            handle.Close();
            _silence.Heard(null);
            _status.Notify();
            TickWithin(TickPeriod);
        }
    }

    public void CutAll()
    {
        lock (_gate)
        {
            CutLinks();
            _status.Notify();
        }
    }

    private void CutLinks()
    {
        foreach (var handle in Machine.Handles.Open.ToArray()) handle.Cut();

        Machine.Serial.Client?.Cut();
    }

    public void With(Action<Machine> action)
    {
        lock (_gate)
        {
            Pace();
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
            Pace();
            _status.Notify();
            TickWithin(TickPeriod);
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
        _timer.Dispose();
        _recordFile.Flush();
    }

    private TimeSpan TickPeriod => _options.IsVirtual ? SilenceWatch.Short : ShortestTick;

    /// <summary>How long nothing can happen of itself. An idle controller takes no processor time at all: the next command wakes it, and catches up with the wall.</summary>
    private TimeSpan QuietTime()
    {
        if (_status.IsAwaited || _desk.HasLateReplies) return TickPeriod;
        if (Machine.IsDormant) return Timeout.InfiniteTimeSpan;
        if (_options.IsVirtual || Machine.Motion.CanProgress) return TickPeriod;
        var milliseconds = (Machine.QuietUntil - Machine.Sample) / _options.Speed;
        return TimeSpan.FromMilliseconds(Math.Clamp(milliseconds, ShortestTick.TotalMilliseconds, LongestTick.TotalMilliseconds));
    }

    /// <summary>Wakes the controller so soon; one that is to wake sooner already does.</summary>
    private void TickWithin(TimeSpan delay)
    {
        if (delay == Timeout.InfiniteTimeSpan) return;
        var due = _options.Time.GetElapsedTime(_started) + delay;
        if (due >= _nextTick) return;
        _nextTick = due;
        _timer.Change(delay, Timeout.InfiniteTimeSpan);
    }

    /// <summary>On a thread of the timer: what is not caught here would end the process.</summary>
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

        _recordFile.Flush();
    }

    private void PassTime()
    {
        _nextTick = TimeSpan.MaxValue;
        Pace();
        _desk.ReleaseReplies();
        if (_options.IsVirtual) _silence.Look();

        _status.Notify();
        TickWithin(QuietTime());
    }

    /// <summary>A bug of the simulator: no state can be trusted any more. Clients are cut, so that none waits for an answer; whoever owns the controller is told.</summary>
    private void Break(Exception bug)
    {
        if (!_broken.TrySetException(new InvalidOperationException($"the simulated controller failed ({bug.GetType().Name}: {bug.Message}); every client was cut off", bug))) return;
        _ = _broken.Task.Exception; // looked at: an owner who does not ask is not told a second time by the runtime
        CutLinks();
    }

    /// <summary>Real time: controller time follows the wall. Where it is to run ahead of the wall, the time that the computing takes does not count: a busy computer
    /// makes the controller slower instead of letting it fall behind its host for ever. Virtual time stands still here.</summary>
    private void Pace()
    {
        if (_options.IsVirtual) return;
        var now = _options.Time.GetElapsedTime(_started);
        Machine.Advance((now - _paced) * _options.Speed);
        _paced = _options.Speed > 1.0 ? _options.Time.GetElapsedTime(_started) : now;
    }
}
