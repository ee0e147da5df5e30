using Engraver.Simulator.Clocks;
using Engraver.Simulator.Language;
using Engraver.Simulator.Protocol;
using Engraver.Simulator.Values;
using System.Runtime.CompilerServices;

namespace Engraver.Simulator;

/// <summary>Executes and answers the commands of hosts, with the faults of the fault plan. All members are called under the controller's lock.</summary>
internal sealed class CommandDispatcher(Machine machine, ControllerClock clock, SimulatorOptions options) : ICommandSink
{
    private readonly DelayedReplies _replies = new(options.Time, options.Faults?.ReplyDelay ?? TimeSpan.Zero);
    private readonly DecodeQueue _decoding = new(options.Time, options.DecodeTime / options.Speed);

    /// <summary>The output of each handle's commands; garbage-collected together with the handle.</summary>
    private readonly ConditionalWeakTable<Handle, CommandContext> _contexts = [];
    private long _commands;
    private TimeSpan _late;

    /// <summary>True while replies that the fault plan delays wait to be sent.</summary>
    public bool HasLateReplies => _replies.AreWaiting;

    /// <summary>Wall time until the next command that is being decoded is executed; null when there is none.</summary>
    public TimeSpan? DecodeRemaining => _decoding.Remaining;

    /// <summary>Sends the delayed replies that are due.</summary>
    public void ReleaseReplies() => _replies.Release();

    /// <summary>Executes the commands whose decode time has passed.</summary>
    public void ReleaseCommands() => _decoding.Release();

    bool ICommandSink.DefersCommand(Handle handle)
    {
        if (options.DecodeTime == TimeSpan.Zero) return false;
        if (clock.FollowsWall) _decoding.Add(handle);
        else clock.Spend(options.DecodeTime);
        return clock.FollowsWall;
    }

    ReadOnlySpan<char> ICommandSink.Execute(Handle handle, ReadOnlySpan<char> text)
    {
        _commands++;
        if (options.Faults is { } faults)
        {
            if (IsFrozen) return default;
            if (faults.BreakDownAtCommand == _commands) throw new InvalidOperationException("The fault plan makes the simulator fail here.");
            if (faults.RefusalOf(_commands) is { } code)
            {
                machine.LastError = code;
                return "?";
            }
        }

        if (machine.Faults.LosesCommand()) return default;
        var reply = Executed(handle, text);
        if (reply.Length > 0 && machine.Faults.LosesReply()) return default;
        LateBy(machine.Faults.TakeDelay());
        return reply;
    }

    /// <summary>Delays the answer: by controller time when it is virtual or a host has the clock, otherwise by wall time.</summary>
    private void LateBy(TimeSpan delay)
    {
        if (clock.FollowsWall) _late = delay;
        else clock.Spend(delay);
    }

    string? ICommandSink.Refuse(Handle handle, int code)
    {
        _commands++;
        machine.LastError = code;
        return IsFrozen ? null : "?";
    }

    bool ICommandSink.StoreLine(string line)
    {
        try
        {
            machine.Program.Append(line);
            return true;
        }
        catch (CommandRefusedException refusal)
        {
            machine.LastError = refusal.Code;
            return false;
        }
    }

    string? ICommandSink.EndDownload(bool failed)
    {
        if (failed)
        {
            machine.Program.Truncate(0); // an incomplete program must not run
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
            machine.LastError = refusal.Code;
            return IsFrozen ? null : "?";
        }
    }

    bool ICommandSink.ByteReceived(Handle handle, byte value)
    {
        machine.Faults.ByteReceived();
        if (handle.IsClosed) return false;
        if (!handle.IsSerial) return true;
        clock.Spend(machine.Serial.ByteTime);
        if (machine.Serial.Echo) handle.Send([value]);
        return handle.IsReceivingText || !machine.Inputs.TakeSerial((char)value);
    }

    void ICommandSink.ReplySent(Handle handle, int replyLength)
    {
        clock.Spend(handle.IsSerial ? machine.Serial.ByteTime * replyLength : options.CommandCost);

        if (options.Faults is not { } faults) return;
        foreach (var drop in faults.Drops)
        {
            if (drop.Handle == handle.Index && handle.Commands == drop.AfterCommands) handle.Cut();
        }
    }

    void ICommandSink.Deliver(Handle handle, ReadOnlySpan<byte> bytes)
    {
        if (machine.Faults.TakeGarbage() is { Length: > 0 } garbage) _replies.Send(handle, garbage, TimeSpan.Zero);
        (var late, _late) = (_late, TimeSpan.Zero);
        _replies.Send(handle, bytes, late);
    }

    void ICommandSink.Closed(Handle handle)
    {
        if (handle.IsSerial) machine.Serial.Client = null;
        else machine.Handles.Remove(handle);
    }

    /// <summary>True after the fault plan's limit is passed: no further command is answered.</summary>
    public bool IsFrozen => options.Faults?.FreezeAfterCommands is { } limit && _commands > limit;

    private ReadOnlySpan<char> Executed(Handle handle, ReadOnlySpan<char> text)
    {
        var context = _contexts.GetValue(handle, CommandContext.From).Restart();
        try
        {
            machine.Interpreter.Execute(text, context);
            var silent = handle.IsReceivingText;
            return silent ? default : context.Output.Append(':').Text;
        }
        catch (CommandRefusedException refusal)
        {
            machine.LastError = refusal.Code;
            return "?";
        }
    }
}
