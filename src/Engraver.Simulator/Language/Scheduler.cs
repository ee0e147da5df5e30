using System.Globalization;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>The eight threads: each running thread executes one line in turn, and every command takes controller time (galil-dmc.md E Threads, A.4).</summary>
internal sealed class Scheduler
{
    public const int ThreadCount = 8;
    private readonly Machine _machine;
    private readonly ProgramThread[] _threads = [.. Enumerable.Range(0, ThreadCount).Select(n => new ProgramThread(n))];
    private TimeSpan _budget;
    private (ProgramThread Thread, WaitLoop Loop)? _waiting;
    private int _turn;

    public Scheduler(Machine machine) => _machine = machine;

    public ProgramThread this[int number] => number is >= 0 and < ThreadCount ? _threads[number] : throw new CommandRefusedException(Tc.OutOfRange);

    /// <summary>Counts released trippoints and ended threads.</summary>
    public long Events { get; private set; }

    /// <summary>Line (_ED0) and thread (_ED1) of the last program error.</summary>
    public (int Line, int Thread) LastError { get; private set; } = (0, -1);

    /// <summary>TR 1: every line is printed before it runs.</summary>
    public bool IsTracing { get; set; }

    /// <summary>Bit mask of running threads: _NO.</summary>
    public int Running
    {
        get
        {
            var mask = 0;
            foreach (var thread in _threads) mask |= thread.IsRunning ? 1 << thread.Number : 0;

            return mask;
        }
    }

    public bool AnyRunning => Running != 0;

    /// <summary>The first sample in which a thread can run while nothing moves; long.MaxValue when only motion or a command can release a thread.</summary>
    public long QuietUntil(long sample)
    {
        var first = long.MaxValue;
        foreach (var thread in _threads)
        {
            if (thread.IsRunning) first = Math.Min(first, ReadyAt(thread, sample));
        }

        return first;
    }

    /// <summary>As <see cref="QuietUntil"/>, during steady motion: a thread in a <see cref="WaitLoop"/> also counts as waiting when it is the only thread that
    /// can run. <see cref="Pass"/> then advances it through its loop.</summary>
    public long QuietWhileSteady(long sample)
    {
        _waiting = null;
        var (first, running) = (long.MaxValue, 0);
        ProgramThread? ready = null;
        foreach (var thread in _threads)
        {
            if (!thread.IsRunning) continue;
            var at = ReadyAt(thread, sample);
            if (at > sample) first = Math.Min(first, at);
            else (ready, running) = (thread, running + 1);
        }

        if (ready is null) return first;
        if (running > 1 || IsTracing || _machine.Options.LineCost == TimeSpan.Zero || ready.Trippoint is not null || WaitLoop.Find(_machine, ready) is not { } loop) return sample;
        _waiting = (ready, loop);
        return first;
    }

    /// <summary>True when the condition of at least one waiting thread holds.</summary>
    public bool IsAnyReleased()
    {
        foreach (var thread in _threads)
        {
            if (thread is { IsRunning: true, Trippoint: { } trippoint } && trippoint.IsReleased()) return true;
        }

        return false;
    }

    /// <summary>Accounts for samples in which only the thread that <see cref="QuietWhileSteady"/> found in a loop could run; processor time overspent earlier
    /// is subtracted first.</summary>
    public void Pass(long samples)
    {
        var time = _budget.Ticks + (samples * TimeSpan.TicksPerMillisecond);
        if (_waiting is var (thread, loop) && time > 0)
        {
            var cost = _machine.Options.LineCost.Ticks;
            var questions = (time + cost - 1) / cost;
            time -= questions * cost;
            thread.JumpTo(loop.LineAfter(questions), 0);
        }

        _waiting = null;
        _budget = TimeSpan.FromTicks(Math.Min(0, time));
    }

    public void ForgetUnusedTime() => _budget = TimeSpan.Zero;

    /// <summary>Releases trippoints and uses one sample of processor time.</summary>
    public void RunSample()
    {
        _budget += TimeSpan.FromTicks(TimeSpan.TicksPerMillisecond);
        ReleaseTrippoints();
        while (_budget > TimeSpan.Zero && NextReady() is { } thread)
        {
            var commands = RunLine(thread);
            _budget -= commands * _machine.Options.LineCost; // a label alone takes no time
            if (_machine.Options.LineCost == TimeSpan.Zero)
            {
                _budget -= TimeSpan.FromTicks(TimeSpan.TicksPerMillisecond / 100); // lines without a cost must not stop the clock
            }
        }

        _budget = _budget > TimeSpan.Zero ? TimeSpan.Zero : _budget;
    }

    public void HaltAll()
    {
        foreach (var thread in _threads) Halt(thread);
    }

    public void Halt(ProgramThread thread)
    {
        Events += thread.IsRunning ? 1 : 0;
        thread.Halt();
    }

    /// <summary>Makes thread 0 run an automatic subroutine (C.3). Returns false when the program does not have it or it cannot run.</summary>
    public bool Interrupt(string label)
    {
        var zero = _threads[0];
        if (!_machine.Program.TryFind(label, out var line) || (!zero.IsRunning && _machine.Options.HandlersNeedThreadZero))
            return false;

        if (zero.Calls.Count >= ProgramThread.DeepestCall)
        {
            // Handlers that never returned have filled the stack: this command error cannot be handled.
            _machine.LastError = Tc.TooDeep;
            LastError = (zero.Line, zero.Number);
            HaltAll();
            return false;
        }

        if (zero.IsRunning)
        {
            zero.Call(line, interrupt: true);
        }
        else
        {
            zero.Start(line, _machine.Sample);
        }

        Events++;
        return true;
    }

    private static long ReadyAt(ProgramThread thread, long sample) =>
        thread.Trippoint is not { } trippoint ? sample
        : trippoint.IsReleased() ? sample
        : trippoint.AtSample ?? long.MaxValue;

    private void ReleaseTrippoints()
    {
        foreach (var thread in _threads)
        {
            if (thread.Trippoint is { } trippoint && trippoint.IsReleased())
            {
                thread.Trippoint = null;
                Events++;
            }
        }
    }

    private ProgramThread? NextReady()
    {
        for (var i = 0; i < ThreadCount; i++)
        {
            _turn = (_turn + 1) % ThreadCount;
            if (_threads[_turn] is { IsRunning: true, Trippoint: null } thread) return thread;
        }

        return null;
    }

    private int RunLine(ProgramThread thread)
    {
        var commands = 0;
        thread.Jumped = false;
        while (thread is { IsRunning: true, Trippoint: null, Jumped: false })
        {
            if (thread.Line >= _machine.Program.Count)
            {
                Fail(thread, thread.Line, null, Tc.UndefinedLabel);
                break;
            }

            var parts = _machine.Program[thread.Line].Parts;
            if (thread.Part >= parts.Length)
            {
                thread.JumpTo(thread.Line + 1, 0);
                break;
            }

            if (IsTracing && commands == 0) Trace(thread.Line);
            commands++;
            RunStatement(thread, thread.Line, parts[thread.Part++]);
        }

        return commands;
    }

    /// <summary>Line number and text, as LS prints them [U].</summary>
    private void Trace(int line) => SendMessage(string.Create(CultureInfo.InvariantCulture, $"{line} {_machine.Program[line].Text}\r\n"), null);

    private void RunStatement(ProgramThread thread, int line, Statement statement)
    {
        var context = thread.Context.Restart();
        try
        {
            _machine.Interpreter.Execute(statement, context);
        }
        catch (CommandRefusedException refusal)
        {
            context.Output.Clear();
            Fail(thread, line, statement, refusal.Code);
        }

        if (context.Output.Length > 0) SendMessage(context.Output.Text, context.OutputHandle);

        Events += thread.IsRunning ? 0 : 1;
    }

    /// <summary>Sends a message of a program. A message that is not acknowledged is error 123 and runs #TCPERR (A.5, C.3).</summary>
    private void SendMessage(ReadOnlySpan<char> text, int? handle)
    {
        if (_machine.Messages.Send(text, handle)) return;
        _machine.LastError = Tc.LostSync;
        Interrupt("TCPERR");
    }

    /// <summary>Handles a command error: without #CMDERR all threads stop; with it only the faulty thread stops, and thread 0 is interrupted (C.3).</summary>
    private void Fail(ProgramThread thread, int line, Statement? statement, int code)
    {
        _machine.LastError = code;
        LastError = (line, thread.Number);
        SendMessage(string.Create(CultureInfo.InvariantCulture, $"?{line} {statement?.Text}\r\n"), null);
        var handled = CanHandle(thread);
        if (thread.Number != 0 || !handled) Halt(thread);

        if (!handled || !Interrupt("CMDERR")) HaltAll();
    }

    /// <summary>False for an error inside #CMDERR itself (the stack is deep or thread 0 is in the handler): then all threads stop.</summary>
    private bool CanHandle(ProgramThread thread) =>
        _machine.Program.TryFind("CMDERR", out _)
        && _threads[0].Calls.Count < ProgramThread.DeepestCall
        && !(thread.Number == 0 && _threads[0].Calls.Any(c => c.Interrupt));
}
