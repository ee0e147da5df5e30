namespace Engraver.Simulator.Language;

/// <summary>Variables and array elements: <c>x=5</c>, <c>x=?</c>, <c>x=</c>, <c>px[i]=5</c>, <c>px[i]=</c> (galil-dmc.md A.3, E).</summary>
internal static class Assignments
{
    public static void Run(StatementReader reader)
    {
        var name = reader.TakeName();
        var array = reader.Next == '[' ? reader.Machine.Variables.ArrayNamed(name) : null;
        var index = array is null ? 0 : reader.TakeIndex();
        reader.Take('=', Tc.Unrecognized);
        if (reader.IsAtEnd || reader.TryTake('?'))
        {
            var value = array is null ? reader.Machine.Variables.Read(name) : array[StatementReader.Checked(index, array)];
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
}
