namespace Engraver.Simulator.Language;

/// <summary>The eight threads. One line of each running thread in turn, every command costs controller time (galil-dmc.md E Threads, A.4).</summary>
internal sealed class Scheduler
{
    public const int ThreadCount = 8;
    private readonly Machine machine;
    private readonly ProgramThread[] threads = [.. Enumerable.Range(0, ThreadCount).Select(n => new ProgramThread(n))];
    private TimeSpan budget;
    private int turn;

    public Scheduler(Machine machine) => this.machine = machine;

    public ProgramThread this[int number] => number is >= 0 and < ThreadCount ? threads[number] : throw new CommandRefusedException(Tc.OutOfRange);

    /// <summary>Counts released trippoints and ended threads.</summary>
    public long Events { get; private set; }

    /// <summary>Line (_ED0) and thread (_ED1) of the last program error.</summary>
    public (int Line, int Thread) LastError { get; private set; } = (0, -1);

    /// <summary>Bit mask of running threads: _NO.</summary>
    public int Running
    {
        get
        {
            int mask = 0;
            foreach (var thread in threads)
            {
                mask |= thread.IsRunning ? 1 << thread.Number : 0;
            }

            return mask;
        }
    }

    public bool AnyRunning => Running != 0;

    /// <summary>The first sample in which a thread can run; long.MaxValue when only motion or a command can release one.</summary>
    public long QuietUntil(long sample)
    {
        long first = long.MaxValue;
        foreach (var thread in threads)
        {
            if (thread.IsRunning)
            {
                first = Math.Min(first, ReadyAt(thread, sample));
            }
        }

        return first;
    }

    public void ForgetUnusedTime() => budget = TimeSpan.Zero;

    /// <summary>Releases trippoints and spends one sample of processor time.</summary>
    public void RunSample()
    {
        budget += TimeSpan.FromTicks(TimeSpan.TicksPerMillisecond);
        ReleaseTrippoints();
        while (budget > TimeSpan.Zero && NextReady() is { } thread)
        {
            int commands = RunLine(thread);
            budget -= commands * machine.Options.LineCost; // a label alone costs nothing
            if (machine.Options.LineCost == TimeSpan.Zero)
            {
                budget -= TimeSpan.FromTicks(TimeSpan.TicksPerMillisecond / 100); // free lines must not stop the clock
            }
        }

        budget = budget > TimeSpan.Zero ? TimeSpan.Zero : budget;
    }

    public void HaltAll()
    {
        foreach (var thread in threads)
        {
            Halt(thread);
        }
    }

    public void Halt(ProgramThread thread)
    {
        Events += thread.IsRunning ? 1 : 0;
        thread.Halt();
    }

    /// <summary>Sends thread 0 into an automatic subroutine (C.3). False when there is none or it cannot run.</summary>
    public bool Interrupt(string label)
    {
        var zero = threads[0];
        if (!machine.Program.TryFind(label, out int line) || (!zero.IsRunning && machine.Options.HandlersNeedThreadZero))
        {
            return false;
        }

        if (zero.IsRunning)
        {
            zero.Call(line, interrupt: true);
        }
        else
        {
            zero.Start(line, machine.Sample);
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
        foreach (var thread in threads)
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
        for (int i = 0; i < ThreadCount; i++)
        {
            turn = (turn + 1) % ThreadCount;
            if (threads[turn] is { IsRunning: true, Trippoint: null } thread)
            {
                return thread;
            }
        }

        return null;
    }

    private int RunLine(ProgramThread thread)
    {
        int commands = 0;
        thread.Jumped = false;
        while (thread is { IsRunning: true, Trippoint: null, Jumped: false })
        {
            if (thread.Line >= machine.Program.Count)
            {
                Fail(thread, thread.Line, "", Tc.UndefinedLabel);
                break;
            }

            var parts = machine.Program[thread.Line].Parts;
            if (thread.Part >= parts.Length)
            {
                thread.JumpTo(thread.Line + 1, 0);
                break;
            }

            commands++;
            RunStatement(thread, thread.Line, parts[thread.Part++]);
        }

        return commands;
    }

    private void RunStatement(ProgramThread thread, int line, string statement)
    {
        var context = CommandContext.Of(thread);
        try
        {
            machine.Interpreter.Execute(statement, context);
        }
        catch (CommandRefusedException refusal)
        {
            Fail(thread, line, statement, refusal.Code);
        }

        if (context.Output.Length > 0)
        {
            machine.Messages.Send(context.Output, context.OutputHandle);
        }

        Events += thread.IsRunning ? 0 : 1;
    }

    /// <summary>Without #CMDERR a command error stops all threads; with it only the faulty one, and thread 0 is interrupted (C.3).</summary>
    private void Fail(ProgramThread thread, int line, string statement, int code)
    {
        machine.LastError = code;
        LastError = (line, thread.Number);
        machine.Messages.Send(new System.Text.StringBuilder().Append('?').Append(line).Append(' ').Append(statement).Append("\r\n"), null);
        bool handled = CanHandle(thread);
        if (thread.Number != 0 || !handled)
        {
            Halt(thread);
        }

        if (!handled || !Interrupt("CMDERR"))
        {
            HaltAll();
        }
    }

    /// <summary>An error inside #CMDERR itself finds the stack deep or thread 0 in the handler: then everything stops.</summary>
    private bool CanHandle(ProgramThread thread) =>
        machine.Program.TryFind("CMDERR", out _)
        && threads[0].Calls.Count < ProgramThread.DeepestCall
        && !(thread.Number == 0 && threads[0].Calls.Any(c => c.Interrupt));
}
