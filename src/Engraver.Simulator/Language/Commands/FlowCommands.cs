using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Program flow (galil-dmc.md E Flow, A.7).</summary>
internal static class FlowCommands
{
    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("JP", CommandScope.Program, Jump),
        new("JS", CommandScope.Program, Call),
        new("EN", CommandScope.Program, End),
        new("RE", CommandScope.Program, End),
        new("RI", CommandScope.Program, ReturnFromInput),
        new("IF", CommandScope.Program, If),
        new("ELSE", CommandScope.Program, r => SkipBlock(r, stopAtElse: false)),
        new("ENDIF", CommandScope.Program, _ => { }),
        new("ZS", CommandScope.Program, ClearStack),
        new("NO", CommandScope.Both, _ => { }),
        new("XQ", CommandScope.Both, Execute),
        new("HX", CommandScope.Both, Halt),
        new("TR", CommandScope.Both, Trace),
    ];

    private static void Jump(StatementReader reader)
    {
        var line = TakeLine(reader);
        if (TakeCondition(reader)) reader.Context.Thread!.JumpTo(line, 0);
    }

    private static void Call(StatementReader reader)
    {
        var line = TakeLine(reader);
        if (TakeCondition(reader)) reader.Context.Thread!.Call(line, interrupt: false);
    }

    private static bool TakeCondition(StatementReader reader)
    {
        var holds = !reader.TryTake(',') || reader.TakeExpression().IsTrue;
        reader.ExpectEnd();
        return holds;
    }

    /// <summary>A line number: that of a label with an optional offset, or the value of an expression.</summary>
    private static int TakeLine(StatementReader reader)
    {
        int line;
        if (reader.TryTake('#'))
        {
            if (!reader.Machine.Program.TryFind(reader.TakeName().ToString(), out line))
                throw new CommandRefusedException(Tc.UndefinedLabel);

            line += reader.Next is '+' or '-' ? reader.TakeExpression().Integer : 0;
        }
        else
        {
            line = reader.TakeExpression().Integer;
        }

        return line >= 0 && line < reader.Machine.Program.Count ? line : throw new CommandRefusedException(Tc.InvalidLine);
    }

    /// <summary>EN, RE, RI: returns from a subroutine, or ends the thread. Argument 1 restores an interrupted trippoint, a second argument arms CI again (C.3);
    /// the third is the value that <c>_JS</c> reads (E Flow).</summary>
    private static void End(StatementReader reader)
    {
        var thread = reader.Context.Thread!;
        var fields = reader.TakeFields();
        reader.ExpectEnd();
        if (fields.ElementAtOrDefault(1).Value is { Integer: 1 }) reader.Machine.SerialInterrupt.Rearm();
        thread.ReturnValue = fields.ElementAtOrDefault(2).Value ?? FixedPoint.Zero;
        if (thread.Calls.Count > 0)
        {
            thread.Return(fields[0].Value is { Integer: 1 });
        }
        else
        {
            thread.Halt();
        }
    }

    /// <summary>RI also arms the input interrupt again (C.3).</summary>
    private static void ReturnFromInput(StatementReader reader)
    {
        End(reader);
        reader.Machine.InputInterrupt.Rearm();
        reader.Machine.Inputs.Watch();
    }

    private static void If(StatementReader reader)
    {
        var holds = reader.TakeExpression().IsTrue;
        reader.ExpectEnd();
        if (!holds) SkipBlock(reader, stopAtElse: true);
    }

    /// <summary>Continues after the matching ENDIF, or after ELSE when a condition failed; blocks may share lines.</summary>
    private static void SkipBlock(StatementReader reader, bool stopAtElse)
    {
        var thread = reader.Context.Thread!;
        var program = reader.Machine.Program;
        var depth = 0;
        var part = thread.Part;
        for (var line = thread.Line; line < program.Count; line++, part = 0)
        {
            for (var parts = program[line].Parts; part < parts.Length; part++)
            {
                var word = parts[part].Command?.Mnemonic;
                if (depth == 0 && (word == "ENDIF" || (word == "ELSE" && stopAtElse)))
                {
                    thread.JumpTo(line, part + 1);
                    return;
                }

                depth += word switch { "IF" => 1, "ENDIF" => -1, _ => 0 };
            }
        }

        throw new CommandRefusedException(Tc.MissingEndif);
    }

    private static void ClearStack(StatementReader reader)
    {
        var calls = reader.Context.Thread!.Calls;
        var levels = reader.IsAtEnd ? 0 : reader.TakeExpression().Integer;
        if (levels == 1)
        {
            calls.TryPop(out _);
        }
        else
        {
            calls.Clear();
        }
    }

    private static void Execute(StatementReader reader)
    {
        var line = reader.IsAtEnd || reader.Next == ',' ? 0 : TakeLine(reader);
        var thread = reader.Machine.Threads[reader.TryTake(',') ? reader.TakeExpression().Integer : 0];
        reader.ExpectEnd();
        if (thread.IsRunning) throw new CommandRefusedException(Tc.ThreadBusy);

        if (line >= reader.Machine.Program.Count) throw new CommandRefusedException(Tc.UndefinedLabel);

        thread.Start(line, reader.Machine.Sample);
    }

    /// <summary>TR 1 prints every program line as a message before it runs, TR 0 stops printing (A.5).</summary>
    private static void Trace(StatementReader reader)
    {
        var field = reader.TakeFields()[0];
        reader.ExpectEnd();
        var threads = reader.Machine.Threads;
        if (field.IsQuery) reader.Context.WriteLine(threads.IsTracing ? " 1" : " 0");
        else threads.IsTracing = AxisParameters.InRange(field.Value?.Integer ?? 0, 0, 1) == 1;
    }

    private static void Halt(StatementReader reader)
    {
        var threads = reader.Machine.Threads;
        if (reader.IsAtEnd)
        {
            threads.HaltAll();
        }
        else
        {
            threads.Halt(threads[reader.TakeExpression().Integer]);
            reader.ExpectEnd();
        }
    }
}
