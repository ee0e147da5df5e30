using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>One of the eight program threads.</summary>
internal sealed class ProgramThread
{
    public const int DeepestCall = 16;

    public ProgramThread(int number)
    {
        Number = number;
        Context = CommandContext.From(this);
    }

    public int Number { get; }

    /// <summary>The output of its commands; cleared for each command.</summary>
    public CommandContext Context { get; }

    public bool IsRunning { get; private set; }

    /// <summary>Line of the next statement.</summary>
    public int Line { get; private set; }

    /// <summary>Statement within the line.</summary>
    public int Part { get; set; }

    /// <summary>The condition that the thread waits for; null when it can run.</summary>
    public Trippoint? Trippoint { get; set; }

    /// <summary>Set by a jump: the rest of the line is skipped.</summary>
    public bool Jumped { get; set; }

    /// <summary>The sample from which AT counts.</summary>
    public long TimeReference { get; set; }

    /// <summary>The value that the last EN returned: <c>_JS</c>.</summary>
    public FixedPoint ReturnValue { get; set; }

    public Stack<CallFrame> Calls { get; } = new();

    public void Start(int line, long sample)
    {
        Calls.Clear();
        ReturnValue = FixedPoint.Zero;
        Trippoint = null;
        TimeReference = sample;
        IsRunning = true;
        JumpTo(line, 0);
    }

    public void Halt()
    {
        IsRunning = false;
        Trippoint = null;
        Calls.Clear();
    }

    public void JumpTo(int line, int part)
    {
        Line = line;
        Part = part;
        Jumped = true;
    }

    public void Call(int line, bool interrupt)
    {
        if (Calls.Count >= DeepestCall) throw new CommandRefusedException(Tc.TooDeep);

        Calls.Push(new CallFrame(Line, Part, interrupt, interrupt ? Trippoint : null));
        Trippoint = null;
        JumpTo(line, 0);
    }

    /// <summary>Returns to the statement after the call.</summary>
    /// <param name="restoreTrippoint">True to wait for an interrupted trippoint again (C.3).</param>
    public void Return(bool restoreTrippoint)
    {
        var frame = Calls.Pop();
        JumpTo(frame.Line, frame.Part);
        Trippoint = restoreTrippoint ? frame.Trippoint : null;
    }
}

/// <summary>Return address of a subroutine or an automatic subroutine.</summary>
/// <param name="Interrupt">True for an automatic subroutine, which can restore the trippoint that it interrupted.</param>
internal readonly record struct CallFrame(int Line, int Part, bool Interrupt, Trippoint? Trippoint);
