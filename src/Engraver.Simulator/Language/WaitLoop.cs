using System.Text.RegularExpressions;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>A few program lines in which a thread only repeats tests of values that steady motion does not change: <c>#ROOM</c>, <c>JP#ROOM,_LMS&lt;50</c>.
/// During the loop, its samples need not be run.</summary>
/// <param name="Label">The line to which the last jump returns.</param>
/// <param name="Jumps">The lines of its conditional jumps, in order; currently only the last one is taken.</param>
/// <param name="Next">Index of the jump that is tested next.</param>
internal sealed partial record WaitLoop(int Label, IReadOnlyList<int> Jumps, int Next)
{
    private const int MaxLines = 6;

    /// <summary>The loop that a thread is in; null when it is not in a wait loop, or would leave the loop now.</summary>
    public static WaitLoop? Find(Machine machine, ProgramThread thread)
    {
        if (thread.Part != 0) return null;
        for (var line = thread.Line; line < Math.Min(machine.Program.Count, thread.Line + MaxLines); line++)
        {
            if (machine.Program[line].Parts.Length == 0) continue;
            if (Read(machine, line) is not { } jump) return null;
            if (Holds(machine, thread, jump.Condition) is not { } holds) return null;
            if (holds) return jump.Target <= thread.Line && thread.Line - jump.Target < MaxLines ? Between(machine, thread, jump.Target, line) : null;
        }

        return null;
    }

    /// <summary>The line of the thread after the given number of further tests.</summary>
    public int LineAfter(long questions) => (Next + questions) % Jumps.Count is > 0 and var jump ? Jumps[(int)jump] : Label;

    private static WaitLoop? Between(Machine machine, ProgramThread thread, int label, int last)
    {
        var jumps = new List<int>();
        for (var line = label; line < last; line++)
        {
            if (machine.Program[line].Parts.Length == 0) continue;
            if (Read(machine, line) is not { } jump || Holds(machine, thread, jump.Condition) is not false) return null;
            jumps.Add(line);
        }

        jumps.Add(last);
        return new WaitLoop(label, jumps, jumps.FindIndex(line => line >= thread.Line));
    }

    /// <summary>A line that is one JP to a label, on a condition that steady motion does not change; null for any other.</summary>
    private static (int Target, string Condition)? Read(Machine machine, int line)
    {
        if (machine.Program[line].Parts is not [{ Command.Mnemonic: "JP", Text: var text }]) return null;
        var jump = Jump().Match(text);
        return jump.Success && machine.Program.TryFind(jump.Groups["label"].Value, out var target) ? (target, jump.Groups["condition"].Value) : null;
    }

    /// <summary>True when the jump would be taken now; null when its condition would be refused, which the thread reports when it runs the line.</summary>
    private static bool? Holds(Machine machine, ProgramThread thread, string condition)
    {
        var reader = new StatementReader(machine).On(condition, thread.Context);
        try
        {
            var holds = reader.TakeExpression().IsTrue;
            return reader.IsAtEnd ? holds : null;
        }
        catch (CommandRefusedException)
        {
            return null;
        }
    }

    /// <summary>Matches a jump on room in the buffer, segments started, motion started, outputs, variables (lower case; the controller's names are in capitals)
    /// and numbers: within a segment at constant speed these do not change.</summary>
    [GeneratedRegex(@"^JP ?#(?<label>\w+),(?<condition>(?:_(?:LM|CS)[ST]?|_BG[A-HST]?|@OUT\[\d\]|[a-z]\w*|\d+|[-+<>=&|()])+)$", RegexOptions.CultureInvariant)]
    private static partial Regex Jump();
}
