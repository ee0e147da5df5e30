namespace Engraver.Simulator.Language.Commands;

/// <summary>The sources that interrupt thread 0: II m,n,o,p (galil-dmc.md D) names inputs, CI m,n (C.3) input on the serial port.</summary>
internal static class InterruptCommands
{
    private const int Inputs = 8;

    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("II", CommandScope.Both, InputInterrupt),
        new("CI", CommandScope.Both, SerialInterrupt),
    ];

    /// <summary>II: first and last input, or a mask, and the interrupt levels.</summary>
    private static void InputInterrupt(StatementReader reader)
    {
        var fields = reader.TakeFields();
        reader.ExpectEnd();
        var levels = (byte)AxisParameters.InRange(Field(fields, 3) ?? 0, 0, 255);
        reader.Machine.InputInterrupt.Arm(Mask(Field(fields, 0), Field(fields, 1), Field(fields, 2)), levels);
        reader.Machine.Inputs.Watch();
    }

    /// <summary>CI 1 interrupts at a carriage return, CI 2 at any character, CI 0 never; CI -1 discards the received input. A second field of 1 disconnects the
    /// port from the command interpreter [U].</summary>
    private static void SerialInterrupt(StatementReader reader)
    {
        var fields = reader.TakeFields();
        reader.ExpectEnd();
        var interrupt = reader.Machine.SerialInterrupt;
        var when = (int)AxisParameters.InRange(Field(fields, 0) ?? interrupt.When, -1, 2);
        var takesData = Field(fields, 1) is { } data ? AxisParameters.InRange(data, 0, 1) == 1 : interrupt.TakesData;
        if (when < 0) interrupt.Clear();
        else interrupt.Configure(when, takesData);
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
