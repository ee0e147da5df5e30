using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Recording into arrays: RA a[],b[] names them, RD _TPA,_TEB the sources, RC n,m starts (galil-dmc.md E, Array; A.8 codes 80 to 82).</summary>
internal static class CaptureCommands
{
    private const int MaxArrays = 8;

    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("RA", CommandScope.Both, NameArrays),
        new("RD", CommandScope.Both, NameSources),
        new("RC", CommandScope.Both, Record),
    ];

    private static void NameArrays(StatementReader reader)
    {
        RefuseWhileRecording(reader);
        var arrays = new List<FixedPoint[]>();
        do
        {
            arrays.Add(arrays.Count < MaxArrays ? MemoryCommands.TakeShortArray(reader) : throw new CommandRefusedException(Tc.TooManyNames));
        }
        while (reader.TryTake(','));
        reader.ExpectEnd();
        reader.Machine.Capture.Arrays = arrays;
    }

    private static void NameSources(StatementReader reader)
    {
        RefuseWhileRecording(reader);
        var sources = new List<Func<FixedPoint>>();
        do
        {
            var source = TakeSource(reader);
            source(); // an axis that does not exist is refused here, not when its first value is due
            sources.Add(source);
        }
        while (reader.TryTake(','));
        reader.ExpectEnd();
        reader.Machine.Capture.Sources = sources;
    }

    /// <summary>TIME, or an operand with its axis; analog inputs are not fitted.</summary>
    private static Func<FixedPoint> TakeSource(StatementReader reader)
    {
        var machine = reader.Machine;
        var isOperand = reader.TryTake('_');
        var name = reader.TakeName();
        if (!isOperand && name is "TIME") return () => FixedPoint.FromInteger((int)machine.Time);
        if (!isOperand || name.Length < 2) throw new CommandRefusedException(Tc.NothingToRecord);
        var request = new OperandRequest(machine, reader.Context, OperandSuffix.Parse(name[2..]));
        return name[..2] switch
        {
            "TP" => () => Whole(request.Axis.Encoder),
            "RP" or "SH" => () => Whole(request.Axis.Reference),
            "TE" => () => Whole(request.Axis.Error),
            "TD" or "DE" => () => Whole(request.Axis.SecondEncoder),
            "RL" => () => Whole(request.Axis.Latch.Position),
            "SC" => () => Whole(request.Axis.StopCode),
            "TS" => () => Whole(ReportCommands.StatusByte(machine, request.Axis)),
            "NO" => () => Whole(DataRecord.Status(machine, request.Axis)),
            "TT" => () => Whole(request.Axis.Index * 0),
            "TI" => () => Whole(machine.Io.Inputs),
            "OP" => () => Whole(machine.Io.Outputs),
            "AF" => throw new CommandRefusedException(Tc.AnalogAbsent),
            _ => throw new CommandRefusedException(Tc.NothingToRecord),
        };
    }

    private static FixedPoint Whole(long value) => FixedPoint.FromInteger(value);

    /// <summary>RC n,m: a value every 2^n samples, m of them; a negative m overwrites endlessly, RC 0 stops.</summary>
    private static void Record(StatementReader reader)
    {
        var fields = reader.TakeFields();
        reader.ExpectEnd();
        var capture = reader.Machine.Capture;
        if (fields[0].IsQuery)
        {
            reader.Context.WriteLine(capture.IsOn ? " 1" : " 0");
            return;
        }

        var exponent = (int)AxisParameters.InRange(fields[0].Value?.Integer ?? throw new CommandRefusedException(Tc.NotEnoughFields), 0, 8);
        if (exponent == 0) capture.Stop();
        else capture.Start(1 << exponent, fields.ElementAtOrDefault(1).Value?.Integer ?? 0);
    }

    private static void RefuseWhileRecording(StatementReader reader)
    {
        if (reader.Machine.Capture.IsOn) throw new CommandRefusedException(Tc.AlreadyRecording);
    }
}
