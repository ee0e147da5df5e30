using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Statements that make only their own thread wait (galil-dmc.md E Trippoints, B.1, C). From a host they are refused with TC 2.</summary>
internal static class TrippointCommands
{
    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("WT", CommandScope.Program, Wait),
        new("AT", CommandScope.Program, AtTime),
        new("AM", CommandScope.Program, AfterMotion),
        new("MC", CommandScope.Program, AfterArrival),
        new("AS", CommandScope.Program, AtSpeed),
        new("AV", CommandScope.Program, AfterVectorDistance),
        new("AI", CommandScope.Program, AfterInput),
        new("AD", CommandScope.Program, r => PerAxis(r, AfterDistance), TakesLetter: true),
        new("AR", CommandScope.Program, r => PerAxis(r, AfterRelativeDistance), TakesLetter: true),
        new("AP", CommandScope.Program, r => PerAxis(r, AfterPosition), TakesLetter: true),
        new("MF", CommandScope.Program, r => PerAxis(r, (a, n) => () => a.Reference >= n), TakesLetter: true),
        new("MR", CommandScope.Program, r => PerAxis(r, (a, n) => () => a.Reference <= n), TakesLetter: true),
    ];

    private static void Set(StatementReader reader, Func<bool> isReleased, long? atSample = null)
    {
        reader.ExpectEnd();
        reader.Context.Thread!.Trippoint = isReleased() ? null : new Trippoint(isReleased, atSample);
    }

    private static void Until(StatementReader reader, long sample) => Set(reader, () => reader.Machine.Sample >= sample, sample);

    private static void Wait(StatementReader reader)
    {
        var samples = reader.TakeExpression().Integer;
        if (samples < 2) throw new CommandRefusedException(Tc.OutOfRange);

        Until(reader, reader.Machine.Sample + Milliseconds(reader, samples & ~1));
    }

    /// <summary>AT 0 sets the reference, AT n waits for it plus n, a negative n also moves the reference.</summary>
    private static void AtTime(StatementReader reader)
    {
        var thread = reader.Context.Thread!;
        var samples = reader.TakeExpression().Integer;
        var release = thread.TimeReference + Milliseconds(reader, Math.Abs((long)samples));
        if (samples == 0) release = reader.Machine.Sample;

        thread.TimeReference = samples <= 0 ? release : thread.TimeReference;
        Until(reader, release);
    }

    /// <summary>A second field 1 counts samples of TM instead of nominal milliseconds.</summary>
    private static long Milliseconds(StatementReader reader, long count) =>
        reader.TryTake(',') && reader.TakeExpression().Integer == 1 ? (long)Math.Ceiling(count / reader.Machine.SamplesPerMillisecond) : count;

    private static void AfterMotion(StatementReader reader)
    {
        var motion = reader.Machine.Motion;
        var selection = reader.TakeAxes();
        Axis[] axes = [.. selection.AxesOrAll];
        VectorPlane[] planes = [.. selection.Planes];
        Set(reader, () => !Array.Exists(axes, motion.IsBusy) && !Array.Exists(planes, p => p.IsActive));
    }

    /// <summary>MC: waits for AM, then until the motors are in position or the TW time-out expires with SC 99 and #MCTIME (C, MC).</summary>
    private static void AfterArrival(StatementReader reader)
    {
        Axis[] axes = [.. reader.TakeAxes().AxesOrAll];
        var arrival = new MotionComplete(reader.Machine, axes);
        Set(reader, arrival.IsOver, atSample: 0);
    }

    private static void AtSpeed(StatementReader reader)
    {
        var selection = reader.TakeAxes();
        Axis[] axes = [.. selection.AxesOrAll];
        VectorPlane[] planes = [.. selection.Planes];
        Set(reader, () => Array.TrueForAll(axes, a => !a.IsMoving || a.IsAtSpeed) && Array.TrueForAll(planes, p => !p.IsActive || p.IsAtSpeed));
    }

    /// <summary>AV counts from the start of the sequence or from the previous AV.</summary>
    private static void AfterVectorDistance(StatementReader reader)
    {
        var fields = reader.TakeFields();
        var index = fields.FindIndex(f => f.Value is not null);
        if (index is < 0 or > 1) throw new CommandRefusedException(Tc.NotEnoughFields);

        var plane = reader.Machine.Motion.Planes[index];
        var target = plane.TrippointReference + Math.Max(0, fields[index].Value!.Value.Value);
        plane.TrippointReference = target;
        Set(reader, () => !plane.IsActive || plane.Profile.Travelled >= target);
    }

    /// <summary>AI n waits for input n high, AI -n for low.</summary>
    private static void AfterInput(StatementReader reader)
    {
        var input = reader.TakeExpression().Integer;
        var io = reader.Machine.Io;
        var number = input > 0 ? input : ~input + 1; // the smallest number has no positive counterpart and is not an input
        io.Input(number);
        Set(reader, () => io.Input(number) == input > 0);
    }

    private static Func<bool> AfterDistance(Axis axis, int distance) =>
        () => !axis.IsMoving || Math.Abs(axis.Position - axis.MoveStart) >= Math.Abs((double)distance);

    /// <summary>AR counts from the position of the previous AR, or from the start of the move.</summary>
    private static Func<bool> AfterRelativeDistance(Axis axis, int distance)
    {
        var start = axis.TrippointReference;
        var length = Math.Abs((double)distance);
        axis.TrippointReference += Math.Sign(axis.Velocity) * length;
        return () => !axis.IsMoving || Math.Abs(axis.Position - start) >= length;
    }

    private static Func<bool> AfterPosition(Axis axis, int position)
    {
        var above = position >= axis.Reference;
        return () => !axis.IsMoving || (above ? axis.Reference >= position : axis.Reference <= position);
    }

    /// <summary>Several axes may be given; the first to reach its position releases the trippoint (C, MF).</summary>
    private static void PerAxis(StatementReader reader, Func<Axis, int, Func<bool>> condition)
    {
        var conditions = new List<Func<bool>>();
        AxisParameters.ForEachValue(reader, (axis, value) => conditions.Add(condition(axis, value.Integer)));
        Set(reader, () => conditions.Exists(c => c()));
    }
}
