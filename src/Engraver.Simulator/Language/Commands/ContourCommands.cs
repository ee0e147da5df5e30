using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;
using static Engraver.Simulator.Language.Commands.VectorCommands;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Contour mode (galil-dmc.md C.4): CM names the axes, DT the interval, CD the increments; WC waits for room.</summary>
internal static class ContourCommands
{
    private const int LargestIncrement = 32_000;
    private const int LargestExponent = 8;

    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("CM", CommandScope.Both, Begin, TakesLetter: true),
        new("DT", CommandScope.Both, SetTime),
        new("CD", CommandScope.Both, Store),
        new("WC", CommandScope.Program, Wait),
    ];

    private static void Begin(StatementReader reader)
    {
        var motion = reader.Machine.Motion;
        if (reader.TryTake('?'))
        {
            reader.ExpectEnd();
            reader.Context.WriteLine(reader.Machine.PrintWhole(motion.Contour.FreeRecords));
            return;
        }

        var selection = reader.TakeAxes();
        reader.ExpectEnd();
        Axis[] axes = [.. selection.AxesOrAll.Distinct()];
        Refuse(selection.Planes.Count > 0 || Array.Exists(axes, a => a.Index >= Axis.Real), Tc.BadAxis);
        Refuse(motion.Contour.IsOn, Tc.NotWhileContouring);
        foreach (var axis in axes)
        {
            Refuse(motion.IsOnCam(axis), Tc.NotOnCamSlave);
            Refuse(motion.IsBusy(axis), Tc.NotWhileRunning);
            Refuse(axis.MotorOff, Tc.MotorOff);
        }

        motion.Contour.Begin(axes);
    }

    private static void SetTime(StatementReader reader)
    {
        var field = reader.TakeFields()[0];
        reader.ExpectEnd();
        var contour = reader.Machine.Motion.Contour;
        if (field.IsQuery)
        {
            reader.Context.WriteLine(reader.Machine.PrintWhole(contour.TimeExponent));
            return;
        }

        contour.TimeExponent = (int)AxisParameters.InRange(field.Value?.Integer ?? throw new CommandRefusedException(Tc.NotEnoughFields), 0, LargestExponent);
    }

    /// <summary>CD a,b,c,d, optionally =n for the interval 2^n. <c>CD 0=0</c>, and CD 0 after DT 0, end the contour.</summary>
    private static void Store(StatementReader reader)
    {
        var motion = reader.Machine.Motion;
        var contour = motion.Contour;
        var fields = reader.TakeFields(comparisons: false);
        var exponent = contour.TimeExponent;
        if (reader.TryTake('=')) exponent = (int)AxisParameters.InRange(reader.TakeExpression().Integer, 0, LargestExponent);
        reader.ExpectEnd();
        Refuse(!contour.IsOn, Tc.NotWhileStopped);
        Refuse(fields.TrueForAll(f => f.Value is null), Tc.NotEnoughFields);
        Refuse(fields.Skip(Axis.Real).Any(f => f.Value is { IsTrue: true }), Tc.BadAxis);
        var increments = new int[contour.Axes.Length];
        for (var i = 0; i < Math.Min(fields.Count, Axis.Real); i++)
        {
            var increment = fields[i].Value?.Integer ?? 0;
            var slot = contour.Axes.IndexOf(motion.Axes[i]);
            Refuse(Math.Abs((long)increment) > LargestIncrement, Tc.ContourRange);
            Refuse(increment != 0 && slot < 0, Tc.BadAxis);
            if (slot >= 0) increments[slot] = increment;
        }

        Refuse(exponent == 0 && Array.Exists(increments, i => i != 0), Tc.NoTimeSpecified);
        contour.Store(new ContourRecord(increments, exponent == 0 ? 0 : 1 << exponent));
        contour.TimeExponent = exponent;
    }

    /// <summary>WC: waits until the previous record has started, so that there is room for the next one (UM17).</summary>
    private static void Wait(StatementReader reader)
    {
        reader.ExpectEnd();
        var contour = reader.Machine.Motion.Contour;
        reader.Context.Thread!.Trippoint = contour.IsReady ? null : new Trippoint(() => contour.IsReady);
    }
}
