using Engraver.Simulator.Language;
using Engraver.Simulator.Protocol;

namespace Engraver.Simulator;

/// <summary>Brings commands, wall time and controller time together under one lock.</summary>
internal sealed class ControllerCore : ICommandSink, IDisposable
{
    private readonly Lock gate = new();
    private readonly SimulatorOptions options;
    private readonly ITimer timer;
    private readonly long started;
    private readonly SilenceWatch silence;
    private readonly DelayedReplies replies;
    private readonly List<StatusWaiter> waiters = [];
    private TimeSpan paced;
    private long commands;

    public ControllerCore(SimulatorOptions options)
    {
        this.options = options;
        Machine = new Machine(options);
        started = options.Time.GetTimestamp();
        silence = new SilenceWatch(Machine, options.Time);
        replies = new DelayedReplies(options.Time, options.Faults?.ReplyDelay ?? TimeSpan.Zero);
        var period = options.IsVirtual ? SilenceWatch.Short : TimeSpan.FromMilliseconds(2);
        timer = options.Time.CreateTimer(_ => Tick(), null, period, period);
    }

    public Machine Machine { get; }

    /// <summary>What stopped the record file from being written; null while all is well.</summary>
    public IOException? RecordFailure { get; private set; }

    public ControllerStatus Status
    {
        get
        {
            lock (gate)
            {
                return StatusNow();
            }
        }
    }

    public Handle? Open(int localPort, int remotePort, Action? disconnect)
    {
        lock (gate)
        {
            Pace();
            silence.Heard();
            return Machine.Handles.TryOpen(i => new Handle(i, localPort, remotePort == 0 ? 1024 + i : remotePort, this) { Disconnect = disconnect });
        }
    }

    /// <summary>Plugs a cable into the serial port; null when one is plugged in.</summary>
    public Handle? OpenSerial(int baud, Action? disconnect)
    {
        lock (gate)
        {
            Pace();
            silence.Heard();
            return Machine.Serial.Plug(baud, new Handle(SerialPort.HandleIndex, 0, 0, this) { Disconnect = disconnect });
        }
    }

    public void Receive(Handle handle, ReadOnlySpan<byte> bytes)
    {
        lock (gate)
        {
            Pace();
            handle.Receive(bytes);
            silence.Heard();
            Notify();
        }
    }

    /// <summary>The client went away: its handle is free again, motion and threads go on.</summary>
    public void Detach(Handle handle)
    {
        lock (gate)
        {
            handle.Close();
            silence.Heard();
            Notify();
        }
    }

    public void CutAll()
    {
        lock (gate)
        {
            foreach (var handle in Machine.Handles.Open.ToArray())
            {
                handle.Cut();
            }

            Machine.Serial.Client?.Cut();
            Notify();
        }
    }

    public void With(Action<Machine> action)
    {
        lock (gate)
        {
            Pace();
            action(Machine);
            Notify();
        }
    }

    public void Advance(TimeSpan time)
    {
        lock (gate)
        {
            Machine.Advance(time);
            Notify();
        }
    }

    public bool AdvanceUntil(Func<ControllerStatus, bool> condition, TimeSpan atMost)
    {
        lock (gate)
        {
            for (long end = Machine.Sample + (long)atMost.TotalMilliseconds; !condition(StatusNow());)
            {
                if (Machine.Sample >= end)
                {
                    return false;
                }

                Machine.Advance(TimeSpan.FromMilliseconds(1));
            }

            Notify();
            return true;
        }
    }

    public async Task<ControllerStatus> WaitUntilAsync(Func<ControllerStatus, bool> condition, CancellationToken cancellation)
    {
        var waiter = new StatusWaiter(condition);
        lock (gate)
        {
            waiters.Add(waiter);
            Notify();
        }

        try
        {
            return await waiter.Task.WaitAsync(cancellation).ConfigureAwait(false);
        }
        finally
        {
            lock (gate)
            {
                waiters.Remove(waiter);
            }
        }
    }

    public void Dispose()
    {
        timer.Dispose();
        CutAll();
        FlushRecord();
    }

    string? ICommandSink.Execute(Handle handle, string text)
    {
        commands++;
        if (options.Faults is { } faults)
        {
            if (faults.FreezeAfterCommands is { } limit && commands > limit)
            {
                return null;
            }

            if (faults.RefusalOf(commands) is { } code)
            {
                Machine.LastError = code;
                return "?";
            }
        }

        return Executed(handle, text);
    }

    string? ICommandSink.Refuse(Handle handle, int code)
    {
        commands++;
        Machine.LastError = code;
        return IsFrozen ? null : "?";
    }

    bool ICommandSink.StoreLine(string line)
    {
        try
        {
            Machine.Program.Append(line);
            return true;
        }
        catch (CommandRefusedException refusal)
        {
            Machine.LastError = refusal.Code;
            return false;
        }
    }

    string? ICommandSink.EndDownload(bool failed)
    {
        if (failed)
        {
            Machine.Program.Truncate(0); // half a program must not run
        }

        return IsFrozen ? null : "::";
    }

    string? ICommandSink.StoreArray(Handle handle, Action store)
    {
        try
        {
            store();
            return IsFrozen ? null : ":";
        }
        catch (CommandRefusedException refusal)
        {
            Machine.LastError = refusal.Code;
            return IsFrozen ? null : "?";
        }
    }

    void ICommandSink.Arrived(Handle handle, byte value)
    {
        if (!handle.IsSerial)
        {
            return;
        }

        if (options.IsVirtual)
        {
            Machine.Advance(Machine.Serial.ByteTime);
        }

        if (Machine.Serial.Echo)
        {
            handle.Send([value]);
        }
    }

    void ICommandSink.Answered(Handle handle, int replyLength)
    {
        if (options.IsVirtual)
        {
            Machine.Advance(handle.IsSerial ? Machine.Serial.ByteTime * replyLength : options.CommandCost);
        }

        foreach (var drop in options.Faults?.Drops ?? [])
        {
            if (drop.Handle == handle.Index && handle.Commands == drop.AfterCommands)
            {
                handle.Cut();
            }
        }
    }

    void ICommandSink.Deliver(Handle handle, ReadOnlySpan<byte> bytes) => replies.Send(handle, bytes);

    void ICommandSink.Closed(Handle handle)
    {
        if (handle.IsSerial)
        {
            Machine.Serial.Client = null;
        }
        else
        {
            Machine.Handles.Remove(handle);
        }
    }

    private bool IsFrozen => options.Faults?.FreezeAfterCommands is { } limit && commands > limit;

    private string? Executed(Handle handle, string text)
    {
        var context = CommandContext.Of(handle);
        try
        {
            Machine.Interpreter.Execute(Statements.Compact(text), context);
            bool silent = handle.IsReceivingText;
            return silent ? null : context.Output.Append(':').ToString();
        }
        catch (CommandRefusedException refusal)
        {
            Machine.LastError = refusal.Code;
            return "?";
        }
    }

    private void Tick()
    {
        lock (gate)
        {
            Pace();
            replies.Release();
            if (options.IsVirtual)
            {
                silence.Look();
            }

            Notify();
        }

        FlushRecord();
    }

    /// <summary>Real time: controller time follows the wall. Virtual time stands still here.</summary>
    private void Pace()
    {
        if (!options.IsVirtual)
        {
            var due = options.Time.GetElapsedTime(started) * options.Speed;
            Machine.Advance(due - paced);
            paced = due;
        }
    }

    private void FlushRecord()
    {
        try
        {
            if (RecordFailure is null)
            {
                Machine.Record.FlushCsv();
            }
        }
        catch (IOException failure)
        {
            RecordFailure = failure;
        }
    }

    private void Notify()
    {
        if (waiters.Count == 0)
        {
            return;
        }

        var status = StatusNow();
        waiters.ForEach(w => w.Offer(status));
    }

    private ControllerStatus StatusNow()
    {
        var planes = Machine.Motion.Planes;
        return new ControllerStatus(
            Machine.Sample,
            Machine.Motion.CanProgress,
            planes[0].IsActive || planes[1].IsActive,
            planes[0].IsDry || planes[1].IsDry,
            Machine.Threads.Running,
            Machine.Io.Outputs,
            planes[0].Underruns + planes[1].Underruns,
            Machine.Handles.Capacity - Machine.Handles.Free);
    }
}
