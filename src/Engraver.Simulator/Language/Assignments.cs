using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>Variables and array elements: <c>x=5</c>, <c>x=?</c>, <c>x=</c>, <c>px[i]=5</c>, <c>px[i]=</c> (galil-dmc.md A.3, E).</summary>
internal static class Assignments
{
    public static void Run(StatementReader reader)
    {
        if (reader.TryTake('~'))
        {
            SetVariableAxis(reader);
            return;
        }

        var name = reader.TakeName();
        var array = reader.Next == '[' ? reader.Machine.Variables.ArrayNamed(name) : null;
        var index = array is null ? 0 : reader.TakeIndex();
        reader.Take('=', Tc.Unrecognized);
        if (reader.IsAtEnd || reader.TryTake('?'))
        {
            var value = array is null ? ValueOf(reader.Machine, name) : array[StatementReader.Checked(index, array)];
            reader.Context.WriteNumber(reader.Machine.ValueFormat, value);
            reader.Context.Output.Append("\r\n");
        }
        else if (array is null)
        {
            reader.Machine.Variables.Write(name, reader.TakeExpression());
        }
        else
        {
            var value = reader.TakeExpression();
            array[StatementReader.Checked(index, array)] = value;
        }

        reader.ExpectEnd();
    }

    private static FixedPoint ValueOf(Machine machine, ReadOnlySpan<char> name) =>
        Keywords.TryRead(machine, name, out var value) ? value : machine.Variables.Read(name);

    /// <summary><c>~a=2</c>, <c>~a=?</c> (E: 0-7 axes, 8 and 9 planes, 10 and 11 virtual axes).</summary>
    private static void SetVariableAxis(StatementReader reader)
    {
        var name = reader.TakeCharacter();
        reader.Take('=', Tc.Unrecognized);
        if (reader.IsAtEnd || reader.TryTake('?')) reader.Context.WriteLine(reader.Machine.Print(FixedPoint.FromInteger(reader.Machine.VariableAxes[name])));
        else reader.Machine.VariableAxes[name] = reader.TakeExpression().Integer;
        reader.ExpectEnd();
    }
}
