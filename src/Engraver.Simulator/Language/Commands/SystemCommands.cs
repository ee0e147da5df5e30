using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Settings of the whole controller (galil-dmc.md A.1, A.3 format commands, C).</summary>
internal static class SystemCommands
{
    private const int MinSampleTime = 250;
    private const int LargestSampleTime = 20000;

    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("\x12\x16", CommandScope.Host, r => r.Context.WriteLine(r.Machine.Options.Model)),
        new("RS", CommandScope.Host, Reset),
        new("TM", CommandScope.Both, SampleTime),
        new("PF", CommandScope.Both, r => Format(r, r.Machine.PositionFormat, f => r.Machine.PositionFormat = f)),
        new("VF", CommandScope.Both, r => Format(r, r.Machine.VariableFormat, f => r.Machine.VariableFormat = f)),
        new("LZ", CommandScope.Both, LeadingZeros),
        new("CN", CommandScope.Both, Polarity),
    ];

    /// <summary>RS: restores the burned state; every connection is closed after its prompt (A.1).</summary>
    private static void Reset(StatementReader reader)
    {
        reader.ExpectEnd();
        reader.Machine.Reset();
        foreach (var handle in reader.Machine.Handles.Open.ToArray())
        {
            handle.CloseWhenAnswered(handle == reader.Context.Handle);
        }
    }

    /// <summary>TM in microseconds; refused in motion. The kernel keeps its 1 ms grid; steps of speeds, WT n,1, TIME and the speeds on segments follow TM
    /// (C).</summary>
    private static void SampleTime(StatementReader reader)
    {
        var field = reader.TakeFields()[0];
        reader.ExpectEnd();
        if (field.IsQuery)
        {
            reader.Context.WriteLine(reader.Machine.PrintWhole(reader.Machine.SampleMicroseconds));
        }
        else
        {
            var motion = reader.Machine.Motion;
            if (motion.CanProgress || Array.Exists(motion.Axes, motion.IsBusy)) throw new CommandRefusedException(Tc.NotWhileRunning);
            reader.Machine.SampleMicroseconds = (int)AxisParameters.InRange(field.Value?.Integer ?? 0, MinSampleTime, LargestSampleTime);
        }
    }

    private static void Format(StatementReader reader, NumberFormat present, Action<NumberFormat> set)
    {
        var field = reader.TakeFields()[0];
        reader.ExpectEnd();
        if (field.IsQuery) reader.Context.WriteLine(new NumberFormat(2, 1, false, false).Print(present.Argument));
        else set(NumberFormat.FromArgument(field.Value ?? throw new CommandRefusedException(Tc.NotEnoughFields)));
    }

    private static void LeadingZeros(StatementReader reader)
    {
        var field = reader.TakeFields()[0];
        reader.ExpectEnd();
        if (field.IsQuery)
        {
            reader.Context.WriteLine(reader.Machine.StripLeadingZeros ? " 1" : " 0");
        }
        else
        {
            reader.Machine.StripLeadingZeros = (field.Value ?? throw new CommandRefusedException(Tc.NotEnoughFields)).IsTrue;
        }
    }

    private static void Polarity(StatementReader reader)
    {
        var fields = reader.TakeFields();
        reader.ExpectEnd();
        var polarity = reader.Machine.Motion.Polarity.Fields;
        for (var i = 0; i < fields.Count && i < polarity.Length; i++)
        {
            polarity[i] = fields[i].Value?.Integer ?? polarity[i];
        }
    }
}
