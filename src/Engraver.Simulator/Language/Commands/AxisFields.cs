using Engraver.Simulator.Motion;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Whole numbers for axes, given by position or by letter, or queried: <c>EM 2000,1000</c>, <c>EMA=2000</c>, <c>EM ?,?</c>.</summary>
internal static class AxisFields
{
    public static void Run(StatementReader reader, Func<Machine, Axis, int> read, Action<Machine, Axis, int> write)
    {
        var asked = new List<string>();
        foreach (var (axis, field) in AxisParameters.TakeAxisFields(reader))
        {
            if (field.IsQuery) asked.Add(reader.Machine.PrintPosition(read(reader.Machine, axis)));
            else if (field.Value is { } value) write(reader.Machine, axis, value.Integer);
        }

        if (asked.Count > 0) reader.Context.WriteLine(ReportCommands.Join(asked));
    }
}
