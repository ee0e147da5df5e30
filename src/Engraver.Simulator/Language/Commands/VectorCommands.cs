using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Coordinated motion: setting up, ending and clearing sequences (galil-dmc.md B.1).</summary>
internal static class VectorCommands
{
    private const int LargestTangentZero = 8_388_607;

    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("CA", CommandScope.Both, SelectPlane),
        new("VM", CommandScope.Both, VectorMode),
        new("LM", CommandScope.Both, LinearMode),
        new("VE", CommandScope.Both, EndSequence),
        new("LE", CommandScope.Both, EndSequence),
        new("CS", CommandScope.Both, ClearSequence),
        new("TN", CommandScope.Both, Tangent),
        new("ES", CommandScope.Both, Scale),
    ];

    private static void SelectPlane(StatementReader reader)
    {
        var motion = reader.Machine.Motion;
        if (reader.TryTake('?'))
        {
            reader.Context.WriteLine(reader.Machine.PrintWhole(motion.Selected.Letter - 'S'));
            return;
        }

        var selection = reader.TakeAxes();
        motion.Selected = selection is { Planes: [var plane], Axes: [] } ? plane : throw new CommandRefusedException(Tc.PlaneNotValid);
    }

    /// <summary>VMAB; VMABC with C along the tangent; VMABN and VMAN with the virtual axis (B.6).</summary>
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
            reader.Context.WriteLine(reader.Machine.PrintWhole(reader.Machine.Motion.Selected.Buffer.FreeSlots));
            return;
        }

        var plane = IdlePlane(reader);
        var axes = reader.TakeAxes().Axes.Distinct().ToArray();
        if (axes.Length == 0) throw new CommandRefusedException(Tc.OperandError);

        plane.SetUp(PlaneMode.Linear, axes, null);
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

    /// <summary>TN m,n: m is set in steps of 1/256 count per degree (B.6).</summary>
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
        plane.Tangent.Zero = AxisParameters.InRange(values[1].Value, -8_388_608, LargestTangentZero);
    }

    private static VectorPlane IdlePlane(StatementReader reader)
    {
        var plane = reader.Machine.Motion.Selected;
        Refuse(plane.IsActive, Tc.NotWhileRunning);
        return plane;
    }

    /// <summary>ES m,n after VM: resolutions of the two axes (B.1).</summary>
    private static void Scale(StatementReader reader)
    {
        var plane = IdlePlane(reader);
        var values = TakeValues(reader, 2);
        reader.ExpectEnd();
        plane.Scale(AxisParameters.InRange(values[0].Integer, 1, 65535), AxisParameters.InRange(values[1].Integer, 1, 65535));
    }

    /// <summary>Reads exactly <paramref name="count"/> values; surplus fields must be empty.</summary>
    public static FixedPoint[] TakeValues(StatementReader reader, int count)
    {
        var fields = reader.TakeFields(comparisons: false);
        Refuse(fields.Count < count || fields.Take(count).Any(f => f.Value is null), Tc.NotEnoughFields);
        Refuse(fields.Skip(count).Any(f => !f.IsMissing), Tc.OperandError);
        return [.. fields.Take(count).Select(f => f.Value!.Value)];
    }

    public static void Refuse(bool condition, int code)
    {
        if (condition) throw new CommandRefusedException(code);
    }
}
