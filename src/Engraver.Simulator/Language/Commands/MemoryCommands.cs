using System.Globalization;
using System.Text;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Program, variable and array memory (galil-dmc.md A.6, E).</summary>
internal static class MemoryCommands
{
    private const char ControlZ = '\x1A';
    private const int LongestNameOnTheWire = 7;

    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("DL", CommandScope.Host, Download),
        new("UL", CommandScope.Host, Upload),
        new("LS", CommandScope.Host, List),
        new("QD", CommandScope.Host, DownloadArray),
        new("QU", CommandScope.Host, UploadArray),
        new("DM", CommandScope.Both, Dimension),
        new("DA", CommandScope.Both, Deallocate),
        new("LA", CommandScope.Both, r => Each(r, r.Machine.Variables.Arrays.OrderBy(a => a.Key, StringComparer.Ordinal).Select(a => Invariant($"{a.Key}[{a.Value.Length}]")))),
        new("LV", CommandScope.Both, r => Each(r, r.Machine.Variables.Variables.OrderBy(v => v.Key, StringComparer.Ordinal).Select(v => $"{v.Key} ={r.Machine.Print(v.Value)}"))),
        new("LL", CommandScope.Both, r => Each(r, r.Machine.Program.Labels.Select(l => Invariant($"#{l.Key}={l.Value}")))),
        new("BP", CommandScope.Both, BurnProgram),
        new("BN", CommandScope.Both, BurnParameters),
        new("BV", CommandScope.Both, BurnVariables),
    ];

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    /// <summary>DL, DL n, DL #label, DL #: from now on the handle takes program text until a terminator.</summary>
    private static void Download(StatementReader reader)
    {
        RefuseWhileRunning(reader);
        var program = reader.Machine.Program;
        var keep = 0;
        if (reader.TryTake('#'))
        {
            var label = reader.TakeName().ToString();
            keep = label.Length == 0 ? program.Count
                : program.TryFind(label, out var line) ? line
                : throw new CommandRefusedException(Tc.UndefinedLabel);
        }
        else if (!reader.IsAtEnd)
        {
            keep = reader.TakeExpression().Integer;
        }

        reader.ExpectEnd();
        program.Truncate(keep >= 0 && keep <= program.Count ? keep : throw new CommandRefusedException(Tc.InvalidLine));
        reader.Context.Handle!.BeginDownload();
    }

    private static void RefuseWhileRunning(StatementReader reader)
    {
        if (reader.Machine.Threads.AnyRunning) throw new CommandRefusedException(Tc.ProgramRunning);
    }

    /// <summary>BN in a program is refused with TC 17, as the text of that code states (E).</summary>
    private static void BurnParameters(StatementReader reader)
    {
        reader.ExpectEnd();
        RefuseWhileRunning(reader);
        reader.Machine.Burned.BurnParameters();
    }

    private static void BurnVariables(StatementReader reader)
    {
        reader.ExpectEnd();
        reader.Machine.Burned.BurnVariables();
    }

    private static void Upload(StatementReader reader)
    {
        reader.ExpectEnd();
        var program = reader.Machine.Program;
        for (var i = 0; i < program.Count; i++) reader.Context.WriteLine(program[i].Text);

        reader.Context.Output.Append(program.Count == 0 ? "\r\n" : "").Append(ControlZ);
    }

    private static void List(StatementReader reader)
    {
        var program = reader.Machine.Program;
        var first = TakeLine(reader) ?? 0;
        var last = reader.TryTake(',') ? TakeLine(reader) : null;
        reader.ExpectEnd();
        if (last < first) throw new CommandRefusedException(Tc.OutOfRange);
        last ??= program.Count - 1;
        for (var i = Math.Max(0, first); i <= Math.Min(last.Value, program.Count - 1); i++)
        {
            reader.Context.WriteLine(Invariant($"{i} {program[i].Text}"));
        }
    }

    /// <summary>A line number, or the line of a label; null when the argument is neither.</summary>
    private static int? TakeLine(StatementReader reader)
    {
        if (!reader.TryTake('#')) return reader.TakeField().Value?.Integer;
        return reader.Machine.Program.TryFind(reader.TakeName().ToString(), out var line) ? line : throw new CommandRefusedException(Tc.UndefinedLabel);
    }

    /// <summary>QD name[],first,last: values follow up to a backslash.</summary>
    private static void DownloadArray(StatementReader reader)
    {
        var (array, first, last, _) = TakeRange(reader);
        reader.Context.Handle!.BeginArrayDownload(text => StoreArray(text, array, first, last));
    }

    private static void StoreArray(string text, FixedPoint[] array, int first, int last)
    {
        var index = first;
        foreach (var item in text.Split(',', '\r'))
        {
            if (item.Length == 0) continue;

            if (!decimal.TryParse(item, NumberStyles.Number, CultureInfo.InvariantCulture, out var value))
                throw new CommandRefusedException(Tc.NotANumber);

            array[index <= last ? index++ : throw new CommandRefusedException(Tc.TooManyElements)] =
                new FixedPoint((long)decimal.Truncate(value * 65536));
        }
    }

    private static void UploadArray(StatementReader reader)
    {
        var (array, first, last, commas) = TakeRange(reader);
        var format = reader.Machine.ValueFormat;
        var output = new StringBuilder();
        for (var i = first; i <= last; i++)
        {
            output.Append(format.Print(array[i])).Append(!commas ? "\r\n" : i < last ? "," : "\r\n");
        }

        reader.Context.Output.Append(output.ToString()).Append(ControlZ);
    }

    private static (FixedPoint[] Array, int First, int Last, bool Commas) TakeRange(StatementReader reader)
    {
        var array = TakeShortArray(reader);
        var fields = reader.TryTake(',') ? reader.TakeFields() : [];
        reader.ExpectEnd();
        var first = fields.ElementAtOrDefault(0).Value?.Integer ?? 0;
        var last = fields.ElementAtOrDefault(1).Value?.Integer ?? array.Length - 1;
        return (array, StatementReader.Checked(first, array), StatementReader.Checked(last, array), fields.ElementAtOrDefault(2).Value is { Integer: 1 });
    }

    /// <summary>name[] of an array for QD, QU and RA, whose names are shorter: up to 7 characters (E, Array).</summary>
    public static FixedPoint[] TakeShortArray(StatementReader reader)
    {
        var name = reader.TakeName();
        var array = name.Length <= LongestNameOnTheWire ? reader.Machine.Variables.ArrayNamed(name, Tc.UndefinedArray) : throw new CommandRefusedException(Tc.UndefinedArray);
        reader.Take('[', Tc.MissingBracket);
        reader.Take(']', Tc.MissingBracket);
        return array;
    }

    private static void Dimension(StatementReader reader)
    {
        if (reader.TryTake('?'))
        {
            reader.Context.WriteLine(reader.Machine.PrintWhole(reader.Machine.Variables.ElementsLeft));
            return;
        }

        do
        {
            var name = reader.TakeName().ToString();
            reader.Machine.Variables.Dimension(name, reader.TakeIndex());
        }
        while (reader.TryTake(','));
        reader.ExpectEnd();
    }

    /// <summary>DA name[], DA name, DA *[] for all arrays, DA * for all variables.</summary>
    private static void Deallocate(StatementReader reader)
    {
        var variables = reader.Machine.Variables;
        if (reader.TryTake('?'))
        {
            reader.Context.WriteLine(reader.Machine.PrintWhole(VariableStore.MaximumArrays - variables.Arrays.Count));
            return;
        }

        do
        {
            var name = reader.TryTake('*') ? "*" : reader.TakeName().ToString();
            var array = reader.TryTake('[');
            if (array) reader.TakeUntil(']', Tc.MissingBracket);

            Remove(variables, name, array);
        }
        while (reader.TryTake(','));
        reader.ExpectEnd();
    }

    private static void Remove(VariableStore variables, string name, bool array)
    {
        if (name != "*")
        {
            var removed = array ? variables.Arrays.Remove(name) : variables.Variables.Remove(name);
            _ = removed ? true : throw new CommandRefusedException(array ? Tc.UndefinedArray : Tc.VariableError);
        }
        else if (array)
        {
            variables.Arrays.Clear();
        }
        else
        {
            variables.Variables.Clear();
        }
    }

    private static void BurnProgram(StatementReader reader)
    {
        if (Array.Exists(reader.Machine.Motion.Axes, reader.Machine.Motion.IsBusy))
            throw new CommandRefusedException(Tc.NotWhileRunning);

        var program = reader.Machine.Program;
        reader.Machine.BurnedProgram = [.. Enumerable.Range(0, program.Count).Select(i => program[i].Text)];
    }

    private static void Each(StatementReader reader, IEnumerable<string> lines)
    {
        reader.ExpectEnd();
        foreach (var line in lines) reader.Context.WriteLine(line);
    }
}
