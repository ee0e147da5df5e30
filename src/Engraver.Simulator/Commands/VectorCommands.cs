using Engraver.Simulator.Language;
using Engraver.Simulator.Motion;

namespace Engraver.Simulator.Commands;

/// <summary>Coordinated motion (galil-dmc.md B).</summary>
internal static class VectorCommands
{
    private const int LongestSegment = 8_388_607;
    private const double LongestBeforeBegin = 1 << 30;

    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("CA", CommandScope.Both, SelectPlane),
        new("VM", CommandScope.Both, VectorMode),
        new("LM", CommandScope.Both, LinearMode),
        new("VP", CommandScope.Both, VectorPosition),
        new("CR", CommandScope.Both, Circle),
        new("LI", CommandScope.Both, LinearIncrement),
        new("VE", CommandScope.Both, EndSequence),
        new("LE", CommandScope.Both, EndSequence),
        new("CS", CommandScope.Both, ClearSequence),
        new("TN", CommandScope.Both, Tangent),
        new("VS", CommandScope.Both, r => PerPlane(r, p => p.VectorSpeed, (p, v) => p.SetSpeed(VectorSpeed(p, v, 2, 12_000_000)), letters: true), TakesLetter: true),
        new("VA", CommandScope.Both, r => PerPlane(r, p => p.Acceleration, (p, v) => p.Acceleration = AxisParameters.Acceleration(v), letters: true), TakesLetter: true),
        new("VD", CommandScope.Both, r => PerPlane(r, p => p.Deceleration, SetDeceleration, letters: true), TakesLetter: true),
        new("VR", CommandScope.Both, r => PerPlane(r, p => p.SpeedRatio, (p, v) => p.SpeedRatio = AxisParameters.InRange(v, 0, 10), letters: false), TakesLetter: true),
    ];

    private static void SelectPlane(StatementReader reader)
    {
        var motion = reader.Machine.Motion;
        if (reader.TryTake('?'))
        {
            reader.Context.WriteLine(NumberFormat.Position.Print(FixedPoint.FromInteger(motion.Selected.Letter - 'S')));
            return;
        }

        var selection = reader.TakeAxes();
        motion.Selected = selection is { Planes: [var plane], Axes: [] } ? plane : throw new CommandRefusedException(Tc.PlaneNotValid);
    }

    /// <summary>VMAB, VMABC with C along the tangent, VMABN and VMAN with the virtual axis (B.6).</summary>
    private static void VectorMode(StatementReader reader)
    {
        var plane = IdlePlane(reader);
        var selection = reader.TakeAxes();
        if (selection.Planes.Count > 0 || selection.Axes.Count is < 2 or > 3 || selection.Axes.Distinct().Count() != selection.Axes.Count)
            throw new CommandRefusedException(Tc.OperandError);

        var third = selection.Axes.ElementAtOrDefault(2);
        plane.SetUp(PlaneMode.Vector, [.. selection.Axes.Take(2)], third is { Index: < Axis.Real } ? third : null);
    }

    private static void LinearMode(StatementReader reader)
    {
        if (reader.TryTake('?'))
        {
            reader.Context.WriteLine(NumberFormat.Position.Print(FixedPoint.FromInteger(reader.Machine.Motion.Selected.Buffer.FreeSlots)));
            return;
        }

        var plane = IdlePlane(reader);
        var axes = reader.TakeAxes().Axes.Distinct().ToArray();
        if (axes.Length == 0) throw new CommandRefusedException(Tc.OperandError);

        plane.SetUp(PlaneMode.Linear, axes, null);
    }

    private static void VectorPosition(StatementReader reader)
    {
        var plane = PlaneIn(reader, PlaneMode.Vector);
        var values = TakeValues(reader, 2);
        plane.PrepareForSegment();
        var segment = new StraightSegment(plane.FrameEnd, [values[0].Integer, values[1].Integer]);
        Refuse(segment.Length > LongestSegment, Tc.OutOfRange);
        StoreWithSpeeds(reader, plane, segment);
    }

    private static void Circle(StatementReader reader)
    {
        var plane = PlaneIn(reader, PlaneMode.Vector);
        var values = TakeValues(reader, 3);
        var options = reader.Machine.Options;
        var radius = Quantized(values[0].Value, options.RadiusQuantum, Math.Truncate);
        var theta = Quantized(values[1].Value, options.AngleQuantumDegrees, Math.Round);
        var sweep = Quantized(values[2].Value, options.AngleQuantumDegrees, Math.Round);
        Refuse(radius is < 10 or > 6_000_000 || Math.Abs(theta) > 32000 || Math.Abs(sweep) > 32000, Tc.OutOfRange);
        Refuse(radius * Math.Abs(sweep) >= 4.5e8, Tc.OutOfRange);
        plane.PrepareForSegment();
        var end = plane.FrameEnd;
        StoreWithSpeeds(reader, plane, new CircularSegment(end[0], end[1], radius, theta, sweep));
    }

    /// <summary>LI is positional over A to D, whatever the order of LM; axes that LM left out must stay empty or zero.</summary>
    private static void LinearIncrement(StatementReader reader)
    {
        var plane = PlaneIn(reader, PlaneMode.Linear);
        var fields = reader.TakeFields(comparisons: false);
        plane.PrepareForSegment();
        var end = plane.FrameEnd.ToArray();
        for (var i = 0; i < fields.Count; i++)
        {
            Refuse(fields[i].IsQuery, 51);
            var increment = fields[i].Value?.Integer ?? 0;
            var slot = i < Axis.Real ? plane.Axes.IndexOf(reader.Machine.Motion.Axes[i]) : -1;
            Refuse(Math.Abs((long)increment) > LongestSegment, Tc.OutOfRange);
            Refuse(increment != 0 && slot < 0, Tc.BadAxis);
            if (slot >= 0) end[slot] += increment;
        }

        var segment = new StraightSegment(plane.FrameEnd, end);
        Refuse(!plane.IsActive && plane.Buffer.Length + segment.Length >= LongestBeforeBegin, Tc.SequenceTooLong);
        StoreWithSpeeds(reader, plane, segment);
    }

    private static void StoreWithSpeeds(StatementReader reader, VectorPlane plane, VectorSegment segment)
    {
        if (reader.TryTake('<'))
            segment.EntrySpeed = VectorSpeed(plane, reader.TakeExpression(comparisons: false).Value, 2, 12_000_000);

        if (reader.TryTake('>'))
            segment.ExitSpeed = VectorSpeed(plane, reader.TakeExpression(comparisons: false).Value, 0, 8_000_000);

        reader.ExpectEnd();
        plane.Store(segment);
    }

    private static void EndSequence(StatementReader reader)
    {
        var plane = reader.Machine.Motion.Selected;
        if (reader.TryTake('?'))
        {
            reader.Context.WriteLine(NumberFormat.Position.Print(FixedPoint.FromDouble(Math.Floor(plane.Buffer.Length + 1e-6))));
            return;
        }

        if (!reader.IsAtEnd) Refuse(reader.TakeExpression().Raw != 0, Tc.OperandError);

        reader.ExpectEnd();
        plane.Close();
    }

    private static void ClearSequence(StatementReader reader)
    {
        var selection = reader.TakeAxes();
        Refuse(selection.Axes.Count > 0, Tc.PlaneNotValid);
        IReadOnlyList<VectorPlane> planes = selection.Planes.Count > 0 ? selection.Planes : [reader.Machine.Motion.Selected];
        foreach (var plane in planes)
        {
            Refuse(plane.IsActive, Tc.NotWhileRunning);
            plane.Clear();
        }
    }

    /// <summary>TN m,n: m in steps of 1/256 count per degree (B.6).</summary>
    private static void Tangent(StatementReader reader)
    {
        var plane = reader.Machine.Motion.Selected;
        if (reader.TryTake('?'))
        {
            reader.Context.WriteLine(NumberFormat.Position.Print(FixedPoint.FromDouble(Math.Round(plane.Tangent.StartFor(plane.Buffer.Current)))));
            return;
        }

        var values = TakeValues(reader, 2);
        reader.ExpectEnd();
        var perDegree = Math.Round(AxisParameters.InRange(values[0].Value, -127, 127) * 256) / 256;
        plane.Tangent.CountsPerDegree = perDegree;
        plane.Tangent.Zero = AxisParameters.InRange(values[1].Value, -8_388_608, LongestSegment);
    }

    private static void SetDeceleration(VectorPlane plane, double value)
    {
        Refuse(plane is { IsActive: true, IsStopping: false }, Tc.NotWhileRunning);
        plane.Deceleration = AxisParameters.Acceleration(value);
    }

    private static double VectorSpeed(VectorPlane plane, double value, double smallest, double largest)
    {
        var stepper = plane.Axes.Length > 0 && plane.Axes.ToArray().Any(a => a.IsStepper);
        return AxisParameters.Speed(value, smallest, stepper ? Math.Min(largest, 3_000_000) : largest);
    }

    /// <summary><c>VS s,t</c>, <c>VSS=n</c>, <c>VS ?</c>, <c>VSS=?</c>; VR has no form with a letter (B.1).</summary>
    private static void PerPlane(StatementReader reader, Func<VectorPlane, double> read, Action<VectorPlane, double> write, bool letters)
    {
        var planes = reader.Machine.Motion.Planes;
        var fields = new List<Field> { default, default };
        if (reader.Next is 'S' or 'T')
        {
            Refuse(!letters, Tc.Unrecognized);
            var index = reader.TakeCharacter() - 'S';
            reader.Take('=', Tc.OperandError);
            var field = reader.TakeField();
            fields[index] = field.IsMissing ? new Field(true, null) : field;
        }
        else
        {
            fields = reader.TakeFields();
        }

        reader.ExpectEnd();
        Refuse(fields.TrueForAll(f => f.IsMissing), Tc.NotEnoughFields);
        var printed = new List<string>();
        for (var i = 0; i < fields.Count; i++)
        {
            Refuse(i > 1 && !fields[i].IsMissing, Tc.PlaneNotValid);
            if (fields[i].IsQuery)
            {
                printed.Add(PrintSetting(read(planes[i]), letters));
            }
            else if (fields[i].Value is { } value)
            {
                write(planes[i], value.Value);
            }
        }

        if (printed.Count > 0) reader.Context.WriteLine(ReportCommands.Join(printed));
    }

    private static string PrintSetting(double value, bool whole) =>
        new NumberFormat(10, whole ? 0 : 4, false, false).Print(FixedPoint.FromDouble(value));

    private static VectorPlane IdlePlane(StatementReader reader)
    {
        var plane = reader.Machine.Motion.Selected;
        Refuse(plane.IsActive, Tc.NotWhileRunning);
        return plane;
    }

    private static VectorPlane PlaneIn(StatementReader reader, PlaneMode mode)
    {
        var plane = reader.Machine.Motion.Selected;
        Refuse(plane.Mode == PlaneMode.None, Tc.PlaneNotValid);
        Refuse(plane.Mode != mode, Tc.SegmentsMixed);
        return plane;
    }

    private static FixedPoint[] TakeValues(StatementReader reader, int count)
    {
        var fields = reader.TakeFields(comparisons: false);
        Refuse(fields.Count < count || fields.Take(count).Any(f => f.Value is null), Tc.NotEnoughFields);
        Refuse(fields.Skip(count).Any(f => !f.IsMissing), Tc.OperandError);
        return [.. fields.Take(count).Select(f => f.Value!.Value)];
    }

    private static double Quantized(double value, double quantum, Func<double, double> round) =>
        quantum > 0 ? round(value / quantum) * quantum : value;

    private static void Refuse(bool condition, int code)
    {
        if (condition) throw new CommandRefusedException(code);
    }
}
