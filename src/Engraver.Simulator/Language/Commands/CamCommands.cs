using Engraver.Simulator.Motion;
using Engraver.Simulator.Motion.Following;
using Engraver.Simulator.Values;
using static Engraver.Simulator.Language.Commands.VectorCommands;

namespace Engraver.Simulator.Language.Commands;

/// <summary>The electronic cam (galil-dmc.md C.4): EA master, EM cycles, EP interval, ET table, EC its index, EB on and off, EG and EQ for each
/// slave.</summary>
internal static class CamCommands
{
    private const int LargestModulus = 8_388_607;
    private const int LargestInterval = 32_767;

    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("EA", CommandScope.Both, SelectMaster, TakesLetter: true),
        new("EM", CommandScope.Both, r => AxisFields.Run(r, (m, a) => CycleOf(m.Motion.Cam, a), SetCycle), TakesLetter: true),
        new("EP", CommandScope.Both, SetInterval),
        new("ET", CommandScope.Both, SetPoint),
        new("EC", CommandScope.Both, SetIndex),
        new("EB", CommandScope.Both, Enable),
        new("EG", CommandScope.Both, r => AxisFields.Run(r, (m, a) => m.Motion.IsOnCam(a) ? 1 : 0, Engage), TakesLetter: true),
        new("EQ", CommandScope.Both, r => AxisFields.Run(r, (m, a) => FollowerOf(m.Motion.Cam, a).Waiting, Disengage), TakesLetter: true),
    ];

    /// <summary>EM of an axis: for the master its modulus, for a slave its change in one cycle; counts.</summary>
    public static int CycleOf(ElectronicCam cam, Axis axis) => axis == cam.Master ? cam.Modulus : FollowerOf(cam, axis).Cycle;

    private static CamFollower FollowerOf(ElectronicCam cam, Axis axis) =>
        axis.Index < Axis.Real ? cam.Followers[axis.Index] : throw new CommandRefusedException(Tc.BadAxis);

    private static void SelectMaster(StatementReader reader)
    {
        var cam = reader.Machine.Motion.Cam;
        Refuse(cam.IsEnabled, Tc.NotWithCamRunning);
        var selection = reader.TakeAxes();
        reader.ExpectEnd();
        cam.Master = selection is { Axes: [var master], Planes: [] } ? master : throw new CommandRefusedException(Tc.OperandError);
    }

    private static void SetCycle(Machine machine, Axis axis, int value)
    {
        var cam = machine.Motion.Cam;
        Refuse(cam.IsEnabled, Tc.NotWithCamRunning);
        if (axis == cam.Master) cam.Modulus = (int)AxisParameters.InRange(value, 1, LargestModulus);
        else FollowerOf(cam, axis).Cycle = (int)AxisParameters.InRange(value, 0, int.MaxValue);
    }

    /// <summary>EP m,n: the interval m may be set only while the cam is off, the shift n at any time.</summary>
    private static void SetInterval(StatementReader reader)
    {
        var fields = reader.TakeFields();
        reader.ExpectEnd();
        var cam = reader.Machine.Motion.Cam;
        if (fields[0].IsQuery)
        {
            reader.Context.WriteLine(reader.Machine.PrintWhole(cam.Interval));
            return;
        }

        if (fields[0].Value is { } interval)
        {
            Refuse(cam.IsEnabled, Tc.NotWithCamRunning);
            cam.Interval = (int)AxisParameters.InRange(interval.Integer, 1, LargestInterval);
        }

        if (fields.ElementAtOrDefault(1).Value is not { } shift) return;
        cam.Shift = shift.Integer;
        reader.Machine.Motion.Unsettle();
    }

    /// <summary>ET[n]=a,b,c,d: position of each slave at point n; ET a,b,c,d sets the point that EC names and advances EC.</summary>
    private static void SetPoint(StatementReader reader)
    {
        var cam = reader.Machine.Motion.Cam;
        var indexed = reader.Next == '[';
        var index = indexed ? reader.TakeIndex() : cam.Index;
        Refuse(index is < 0 or >= ElectronicCam.Points, Tc.CamIndex);
        if (indexed) reader.Take('=', Tc.OperandError);
        var fields = reader.TakeFields();
        reader.ExpectEnd();
        Refuse(fields.TrueForAll(f => f.IsMissing), Tc.NotEnoughFields);
        Refuse(fields.Skip(Axis.Real).Any(f => !f.IsMissing), Tc.BadAxis);
        var asked = new List<string>();
        for (var i = 0; i < Math.Min(fields.Count, Axis.Real); i++)
        {
            if (fields[i].IsQuery) asked.Add(reader.Machine.PrintWhole(cam.Followers[i][index]));
            if (fields[i].Value is { } value) cam.Followers[i][index] = value.Integer;
        }

        if (asked.Count > 0) reader.Context.WriteLine(ReportCommands.Join(asked));
        if (!indexed) cam.Index = index + 1;
    }

    private static void SetIndex(StatementReader reader)
    {
        var field = reader.TakeFields()[0];
        reader.ExpectEnd();
        var cam = reader.Machine.Motion.Cam;
        if (field.IsQuery)
        {
            reader.Context.WriteLine(reader.Machine.PrintWhole(cam.Index));
            return;
        }

        var index = field.Value?.Integer ?? throw new CommandRefusedException(Tc.NotEnoughFields);
        cam.Index = index is >= 0 and < ElectronicCam.Points ? index : throw new CommandRefusedException(Tc.CamIndex);
    }

    private static void Enable(StatementReader reader)
    {
        var field = reader.TakeFields()[0];
        reader.ExpectEnd();
        var cam = reader.Machine.Motion.Cam;
        if (field.IsQuery)
        {
            reader.Context.WriteLine(cam.IsEnabled ? " 1" : " 0");
            return;
        }

        var on = AxisParameters.InRange(field.Value?.Value ?? throw new CommandRefusedException(Tc.NotEnoughFields), 0, 1) == 1;
        if (!on) cam.Disable(StopCode.CamStopped);
        else if (!cam.IsEnabled) cam.Enable();
    }

    /// <summary>EG: engages when the master is at this position of its cycle, or at once for a number outside the cycle. A slave that another mode drives is
    /// refused.</summary>
    private static void Engage(Machine machine, Axis axis, int place)
    {
        var cam = machine.Motion.Cam;
        Refuse(!cam.IsEnabled, Tc.CamNotEnabled);
        Refuse(axis == cam.Master, Tc.MasterAndFollower);
        Refuse(machine.Motion.IsOnCam(axis), Tc.NotOnCamSlave);
        Refuse(machine.Motion.Contour.Drives(axis), Tc.NotWhileContouring);
        Refuse(machine.Motion.IsBusy(axis), Tc.NotWhileRunning);
        FollowerOf(cam, axis).Engage(cam, place);
        machine.Motion.Unsettle();
    }

    private static void Disengage(Machine machine, Axis axis, int place)
    {
        var cam = machine.Motion.Cam;
        Refuse(!cam.IsEnabled, Tc.CamNotEnabled);
        FollowerOf(cam, axis).Disengage(cam, place);
    }
}
