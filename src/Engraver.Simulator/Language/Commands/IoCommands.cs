using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Outputs and inputs (galil-dmc.md D). Outputs change when the command runs, not in step with the path.</summary>
internal static class IoCommands
{
    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("SB", CommandScope.Both, r => Write(r, TakeBit(r), true)),
        new("CB", CommandScope.Both, r => Write(r, TakeBit(r), false)),
        new("OB", CommandScope.Both, OutputBit),
        new("OP", CommandScope.Both, OutputPort),
        new("TI", CommandScope.Both, ReportInputs),
    ];

    private static int TakeBit(StatementReader reader) => reader.TakeExpression().Integer;

    private static void Write(StatementReader reader, int bit, bool level)
    {
        reader.ExpectEnd();
        reader.Machine.Io.Output(bit); // refuses a bit that does not exist
        var mask = 1 << (bit - 1);
        int outputs = reader.Machine.Io.Outputs;
        reader.Machine.SetOutputs((byte)(level ? outputs | mask : outputs & ~mask));
    }

    private static void OutputBit(StatementReader reader)
    {
        var bit = TakeBit(reader);
        reader.Take(',', Tc.NotEnoughFields);
        var level = reader.TakeExpression().IsTrue;
        Write(reader, bit, level);
    }

    private static void OutputPort(StatementReader reader)
    {
        var field = reader.TakeFields()[0];
        reader.ExpectEnd();
        if (field.IsQuery)
        {
            reader.Context.WriteLine(reader.Machine.PrintWhole(reader.Machine.Io.Outputs));
            return;
        }

        var value = field.Value ?? throw new CommandRefusedException(Tc.NotEnoughFields);
        reader.Machine.SetOutputs((byte)AxisParameters.InRange(value.Integer, 0, 255));
    }

    private static void ReportInputs(StatementReader reader)
    {
        var bank = reader.IsAtEnd ? 0 : reader.TakeExpression().Integer;
        reader.ExpectEnd();
        int value = bank == 0 ? reader.Machine.Io.Inputs : throw new CommandRefusedException(Tc.OutOfRange);
        reader.Context.WriteLine(reader.Machine.PrintWhole(value));
    }
}
