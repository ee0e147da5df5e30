using Engraver.Simulator.Language;

namespace Engraver.Simulator.Commands;

/// <summary>II m,n,o,p (galil-dmc.md D): first and last input, or a mask, and the levels wanted.</summary>
internal static class InterruptCommands
{
    private const int Inputs = 8;

    public static IEnumerable<CommandEntry> Entries { get; } = [new("II", CommandScope.Both, InputInterrupt)];

    private static void InputInterrupt(StatementReader reader)
    {
        var fields = reader.TakeFields();
        reader.ExpectEnd();
        var levels = (byte)AxisParameters.InRange(Field(fields, 3) ?? 0, 0, 255);
        reader.Machine.InputInterrupt.Arm(Mask(Field(fields, 0), Field(fields, 1), Field(fields, 2)), levels);
        reader.Machine.WatchInputs();
    }

    private static byte Mask(int? first, int? last, int? mask)
    {
        if (first is null) return (byte)AxisParameters.InRange(mask ?? 0, 0, 255);
        var from = (int)AxisParameters.InRange(first.Value, 0, Inputs);
        if (from == 0) return 0;
        var to = (int)AxisParameters.InRange(last ?? from, from, Inputs);
        return (byte)((1 << to) - (1 << (from - 1)));
    }

    private static int? Field(List<Field> fields, int index) => fields.ElementAtOrDefault(index).Value?.Integer;
}
