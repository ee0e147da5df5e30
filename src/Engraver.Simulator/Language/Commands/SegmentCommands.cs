using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;
using static Engraver.Simulator.Language.Commands.VectorCommands;

namespace Engraver.Simulator.Language.Commands;

/// <summary>The segments of a sequence: VP, CR, LI with their speeds (galil-dmc.md B.1 to B.4).</summary>
internal static class SegmentCommands
{
    private const int LongestSegment = 8_388_607;
    private const double LongestBeforeBegin = 1 << 30;

    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("VP", CommandScope.Both, VectorPosition),
        new("CR", CommandScope.Both, Circle),
        new("LI", CommandScope.Both, LinearIncrement, TakesLetter: true),
    ];

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
        var fields = TakeIncrements(reader);
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

    /// <summary>LIA=n is LI with one field (B.1).</summary>
    private static List<Field> TakeIncrements(StatementReader reader)
    {
        Refuse(AxisSelection.IsAbsent(reader.Rest), Tc.BadAxis);
        if (AxisSelection.IndexOf(reader.Next) is not (>= 0 and < Axis.Real) || reader.Rest is not [_, '=', ..]) return reader.TakeFields(comparisons: false);
        var fields = Enumerable.Repeat(default(Field), Axis.Real).ToList();
        var slot = AxisSelection.IndexOf(reader.TakeCharacter());
        reader.Take('=', Tc.OperandError);
        fields[slot] = reader.TakeField(comparisons: false);
        return fields;
    }

    private static void StoreWithSpeeds(StatementReader reader, VectorPlane plane, VectorSegment segment)
    {
        if (reader.TryTake('<'))
            segment.EntrySpeed = SpeedOfSample(reader, plane, 2, 12_000_000);

        if (reader.TryTake('>'))
            segment.ExitSpeed = SpeedOfSample(reader, plane, 0, 8_000_000);

        reader.ExpectEnd();
        plane.Store(segment);
    }

    /// <summary>A speed attached to a segment. It is counted per sample and, unlike VS, is not rescaled by TM (B.4).</summary>
    private static double SpeedOfSample(StatementReader reader, VectorPlane plane, double smallest, double largest) =>
        PlaneSettings.VectorSpeed(plane, reader.TakeExpression(comparisons: false).Value, smallest, largest) * reader.Machine.SamplesPerMillisecond;

    private static VectorPlane PlaneIn(StatementReader reader, PlaneMode mode)
    {
        var plane = reader.Machine.Motion.Selected;
        Refuse(plane.Mode == PlaneMode.None, Tc.PlaneNotValid);
        Refuse(plane.Mode != mode, Tc.SegmentsMixed);
        return plane;
    }

    private static double Quantized(double value, double quantum, Func<double, double> round) =>
        quantum > 0 ? round(value / quantum) * quantum : value;
}
