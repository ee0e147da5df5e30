using System.Collections.Frozen;
using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>The table of per-axis settings (galil-dmc.md C): <c>SP a,b</c>, <c>SPA=n</c>, <c>SP*=n</c>, <c>SP ?,?</c>, <c>SPA=?</c>.</summary>
internal static class AxisParameters
{
    public const double LargestAcceleration = 67_107_840;
    private const double AccelerationStep = 1024;
    private static readonly NumberFormat Whole = new(10, 0, false, false);

    public static IReadOnlyList<AxisParameter> All { get; } =
    [
        new("SP", a => FixedPoint.FromDouble(a.CruiseSpeed), (m, a, v) => a.CruiseSpeed = Speed(Math.Abs(v.Value), 0, LargestSpeed(a), m.SamplesPerMillisecond), Whole),
        new("AC", a => FixedPoint.FromDouble(a.Acceleration), (m, a, v) => a.Acceleration = Acceleration(v.Value, m.SamplesPerMillisecond), Whole),
        new("DC", a => FixedPoint.FromDouble(a.Deceleration), SetDeceleration, Whole),
        new("JG", a => FixedPoint.FromDouble(Math.Abs(a.JogSpeed)), SetJog, Whole),
        new("PA", a => FixedPoint.FromInteger(a.LastStop), SetAbsolute),
        new("PR", a => FixedPoint.FromInteger(a.NextMove == AxisMove.Absolute ? a.AbsoluteTarget - a.Reference : a.RelativeDistance), SetRelative),
        new("DP", a => FixedPoint.FromInteger(a.Reference), SetPosition),
        new("FL", a => FixedPoint.FromInteger(a.ForwardSoftLimit), (_, a, v) => a.ForwardSoftLimit = v.Integer),
        new("BL", a => FixedPoint.FromInteger(a.ReverseSoftLimit), (_, a, v) => a.ReverseSoftLimit = v.Integer),
        new("MT", a => a.MotorType, SetMotorType, new NumberFormat(4, 1, false, false)),
        new("OE", a => FixedPoint.FromInteger(a.OffOnError), (_, a, v) => a.OffOnError = (int)InRange(v.Value, 0, 3), Whole),
        Stored("KP", 6, 0, 1023.875, 2),
        Stored("KI", 0, 0, 255.999, 4),
        Stored("KD", 64, 0, 4095.875, 2),
        new("ER", a => FixedPoint.FromDouble(a.ErrorLimit), (_, a, v) => a.ErrorLimit = InRange(v.Value, -1, 2147483647), Whole),
        new("PT", a => FixedPoint.FromBoolean(a.IsTracking), SetTracking, Whole),
        new("IP", a => FixedPoint.FromInteger(a.RelativeDistance), IncrementPosition),
        new("DE", a => FixedPoint.FromInteger(a.Auxiliary), (_, a, v) => a.Auxiliary = v.Integer),
        new("GR", a => FixedPoint.FromDouble(a.Gear.Ratio), SetGearRatio, NumberFormat.Variable),
        new("GM", a => FixedPoint.FromBoolean(a.Gear.IsGantry), (_, a, v) => a.Gear.IsGantry = v.IsTrue, Whole),
        Stored("TL", 9.9982, 0, 9.9982, 4),
        Stored("TK", 0, 0, 9.9982, 4),
        Stored("IL", 9.9982, -9.9982, 9.9982, 4),
        Stored("OF", 0, -9.9982, 9.9982, 4),
        Stored("KS", 2, 0.5, 64, 3),
        Stored("IT", 1, 0.004, 1, 4),
        NotInMotion(Stored("CE", 0, 0, 15, 0)),
        Stored("FA", 0, 0, 8191, 2),
        Stored("FV", 0, 0, 8191, 0),
        Stored("TW", 32766, -1, 32766, 0),
    ];

    private static readonly FrozenDictionary<string, AxisParameter> Table = All.ToFrozenDictionary(p => p.Mnemonic, StringComparer.Ordinal);

    public static IEnumerable<CommandEntry> Entries { get; } =
        All.Select(p => new CommandEntry(p.Mnemonic, CommandScope.Both, r => Run(r, p), TakesLetter: true));

    private static readonly FrozenDictionary<string, AxisParameter>.AlternateLookup<ReadOnlySpan<char>> Lookup = Table.GetAlternateLookup<ReadOnlySpan<char>>();

    public static AxisParameter? Find(ReadOnlySpan<char> mnemonic) => Lookup.TryGetValue(mnemonic, out var parameter) ? parameter : null;

    /// <summary>Calls <paramref name="apply"/> for every axis that has a value, by position or by letter.</summary>
    public static void ForEachValue(StatementReader reader, Action<Axis, FixedPoint> apply)
    {
        foreach (var (axis, field) in TakeAxisFields(reader))
        {
            if (field.Value is { } value) apply(axis, value);
        }
    }

    /// <summary>A speed rounded to an even number of counts/s (C, SP); a speed outside the range is refused with TC 6.</summary>
    /// <param name="samplesPerMillisecond">1000/TM: the step is 2 counts a sample.</param>
    public static double Speed(double value, double smallest, double largest, double samplesPerMillisecond = 1)
    {
        var step = 2 * samplesPerMillisecond;
        var even = Math.Truncate(value / step) * step;
        return even >= smallest && value <= largest ? even : throw new CommandRefusedException(Tc.OutOfRange);
    }

    /// <summary>An acceleration rounded down to a multiple of 1024 counts/s2 (L.2 point 10).</summary>
    /// <param name="samplesPerMillisecond">1000/TM: the step grows with its square (C, AC).</param>
    public static double Acceleration(double value, double samplesPerMillisecond = 1)
    {
        var step = AccelerationStep * samplesPerMillisecond * samplesPerMillisecond;
        return Math.Floor(InRange(value, step, LargestAcceleration) / step) * step;
    }

    public static double InRange(double value, double smallest, double largest) =>
        value >= smallest && value <= largest ? value : throw new CommandRefusedException(Tc.OutOfRange);

    public static double LargestSpeed(Axis axis) => axis.IsStepper ? 3_000_000 : 12_000_000;

    private static AxisParameter Stored(string mnemonic, double start, double smallest, double largest, int decimals) => new(
        mnemonic,
        a => a.Settings.TryGetValue(mnemonic, out var value) ? value : FixedPoint.FromDouble(start),
        (_, a, v) => a.Settings[mnemonic] = FixedPoint.FromDouble(InRange(v.Value, smallest, largest)),
        new NumberFormat(10, decimals, false, false));

    private static AxisParameter NotInMotion(AxisParameter parameter) => parameter with
    {
        Write = (m, a, v) =>
        {
            NotWhileBusy(m, a);
            parameter.Write!(m, a, v);
        },
    };

    private static void Run(StatementReader reader, AxisParameter parameter)
    {
        var printed = new List<string>();
        foreach (var (axis, field) in TakeAxisFields(reader))
        {
            if (field.IsQuery)
            {
                printed.Add(reader.Machine.Padded(parameter.Format ?? reader.Machine.PositionFormat).Print(parameter.Read(axis)));
            }
            else if (field.Value is { } value)
            {
                parameter.Write!(reader.Machine, axis, value);
            }
        }

        if (printed.Count > 0) reader.Context.WriteLine(ReportCommands.Join(printed));
    }

    public static List<(Axis Axis, Field Field)> TakeAxisFields(StatementReader reader)
    {
        var axes = reader.Machine.Motion.Axes;
        var result = new List<(Axis, Field)>();
        if (AxisSelection.IndexOf(reader.Next) >= 0 || reader.Next is '*' or '~' || AxisSelection.IsAbsent(reader.Rest))
        {
            var selection = reader.TakeAxes();
            reader.Take('=', Tc.OperandError);
            var field = reader.TakeField();
            result.AddRange(selection.Axes.Select(a => (a, field.IsMissing ? new Field(true, null) : field)));
        }
        else
        {
            var fields = reader.TakeFields();
            // Surplus fields are tolerated when they are empty (L.2 point 8).
            for (var i = 0; i < fields.Count; i++)
            {
                if (!fields[i].IsMissing)
                    result.Add(i < Axis.Real ? (axes[i], fields[i]) : throw new CommandRefusedException(Tc.BadAxis));
            }
        }

        reader.ExpectEnd();
        return result.Count > 0 ? result : throw new CommandRefusedException(Tc.NotEnoughFields);
    }

    private static void NotWhileBusy(Machine machine, Axis axis)
    {
        if (machine.Motion.IsBusy(axis)) throw new CommandRefusedException(Tc.NotWhileRunning);
    }

    /// <summary>DC in motion is refused unless the axis jogs or is already stopping (C).</summary>
    private static void SetDeceleration(Machine machine, Axis axis, FixedPoint value)
    {
        if (axis is { IsMoving: true, IsStopping: false, CurrentMove: not AxisMove.Jog })
            throw new CommandRefusedException(Tc.NotWhileRunning);

        axis.Deceleration = Acceleration(value.Value, machine.SamplesPerMillisecond);
    }

    /// <summary>JG also overwrites SP with its absolute value (C).</summary>
    private static void SetJog(Machine machine, Axis axis, FixedPoint value)
    {
        if (axis.IsMoving && axis.CurrentMove != AxisMove.Jog) throw new CommandRefusedException(Tc.NotJogging);

        var speed = Speed(Math.Abs(value.Value), 0, LargestSpeed(axis), machine.SamplesPerMillisecond);
        axis.JogSpeed = value.Raw < 0 ? -speed : speed;
        axis.CruiseSpeed = speed;
        axis.NextMove = AxisMove.Jog;
    }

    /// <summary>Under PT the axis starts for the target at once (C, PT).</summary>
    private static void SetAbsolute(Machine machine, Axis axis, FixedPoint value)
    {
        if (axis.IsTracking)
        {
            if (axis.MotorOff) throw new CommandRefusedException(Tc.MotorOff);
            IndependentCommands.CheckModes(machine.Motion, axis);
            axis.Track(value.Integer);
            return;
        }

        NotWhileBusy(machine, axis);
        axis.AbsoluteTarget = value.Integer;
        axis.NextMove = AxisMove.Absolute;
    }

    private static void SetRelative(Machine machine, Axis axis, FixedPoint value)
    {
        NotWhileBusy(machine, axis);
        axis.RelativeDistance = value.Integer;
        axis.NextMove = AxisMove.Relative;
    }

    private static void SetPosition(Machine machine, Axis axis, FixedPoint value)
    {
        NotWhileBusy(machine, axis);
        IndependentCommands.CheckModes(machine.Motion, axis);
        if (machine.Motion.Cam.IsEnabled && machine.Motion.Cam.Master == axis) throw new CommandRefusedException(Tc.NotWithCamRunning);
        axis.Redefine(value.Integer);
    }

    /// <summary>MT requires the motor to be off (C).</summary>
    private static void SetMotorType(Machine machine, Axis axis, FixedPoint value)
    {
        NotWhileBusy(machine, axis);
        if (!axis.MotorOff) throw new CommandRefusedException(Tc.NotWhileRunning);

        var magnitude = Math.Abs(value.Value);
        axis.MotorType = magnitude is 1 or 1.5 or 2 or 2.5 ? value : throw new CommandRefusedException(Tc.OutOfRange);
    }

    private static void SetTracking(Machine machine, Axis axis, FixedPoint value)
    {
        NotWhileBusy(machine, axis);
        axis.IsTracking = InRange(value.Value, 0, 1) == 1;
    }

    /// <summary>IP at rest equals PR and BG; in motion it extends the move or, in a jog, jumps by the distance (C).</summary>
    private static void IncrementPosition(Machine machine, Axis axis, FixedPoint value)
    {
        if (axis.IsMoving)
        {
            axis.Extend(value.Integer);
            return;
        }

        SetRelative(machine, axis, value);
        IndependentCommands.CheckAxis(machine.Motion, axis);
        axis.Begin();
    }

    private static void SetGearRatio(Machine machine, Axis axis, FixedPoint value) =>
        axis.Gear.Engage(InRange(value.Value, -127, 127), machine.Motion.PlaceOfMaster(axis.Gear.Master));
}

/// <summary>A setting that every axis has, readable as <c>_XXa</c>, <c>XX ?</c> and <c>XXa=?</c>.</summary>
/// <param name="Write">Null for a read-only setting.</param>
/// <param name="Format">Format of the reply to a query; null for the position format PF.</param>
internal sealed record AxisParameter(
    string Mnemonic,
    Func<Axis, FixedPoint> Read,
    Action<Machine, Axis, FixedPoint>? Write,
    NumberFormat? Format = null);
