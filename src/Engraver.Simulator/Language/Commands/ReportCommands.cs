using System.Globalization;
using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Queries of the state (galil-dmc.md A.3 number replies, A.8 to A.10) and MG.</summary>
internal static class ReportCommands
{
    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("TP", CommandScope.Both, r => PerAxis(r, (m, a) => Position(m, a.Encoder))),
        new("RP", CommandScope.Both, r => PerAxis(r, (m, a) => Position(m, a.Reference))),
        new("TD", CommandScope.Both, r => PerAxis(r, (m, a) => Position(m, a.SecondEncoder))),
        new("TE", CommandScope.Both, r => PerAxis(r, (m, a) => Position(m, a.Error))),
        new("TV", CommandScope.Both, r => PerAxis(r, (m, a) => Position(m, (int)Math.Round(m.Motion.VelocityOf(a))))),
        new("TT", CommandScope.Both, r => PerAxis(r, (_, _) => " 0.0000")),
        new("SC", CommandScope.Both, r => PerAxis(r, (m, a) => Position(m, a.StopCode))),
        new("RL", CommandScope.Both, r => PerAxis(r, (m, a) => Position(m, a.Latch.Position))),
        new("TS", CommandScope.Both, r => PerAxis(r, (m, a) => Position(m, StatusByte(m, a)))),
        new("TB", CommandScope.Both, StatusOfController),
        new("TC", CommandScope.Both, ErrorCode),
        new("QZ", CommandScope.Both, r => r.Context.WriteLine(" 4, 24, 16, 28")),
        new("QR", CommandScope.Host, r => r.Context.Output.Append(DataRecord.Build(r.Machine, r.TakeRest()))),
        new("MG", CommandScope.Both, r => MessageText.Write(r)),
    ];

    /// <summary>Values with a leading blank or minus each, separated by a comma and a blank (A.3).</summary>
    public static string Join(IEnumerable<string> values) =>
        string.Concat(values.Select((v, i) => i == 0 ? v : ", " + v.TrimStart(' ')));

    /// <summary>TS: bit 7 moving, 5 motor off, 3 and 2 limits inactive, 1 home, 0 latch not armed (A.10).</summary>
    public static int StatusByte(Machine machine, Axis axis) =>
        (axis.Latch.IsArmed ? 0 : 0x01)
        | (axis.Inputs.Home ? 0x02 : 0)
        | (Math.Abs(axis.Error) > axis.ErrorLimit && axis.ErrorLimit > 0 ? 0x40 : 0)
        | (machine.Motion.IsBusy(axis) ? 0x80 : 0)
        | (axis.MotorOff ? 0x20 : 0)
        | (axis.Inputs.ForwardHit ? 0 : 0x08)
        | (axis.Inputs.ReverseHit ? 0 : 0x04);

    private static string Position(Machine machine, int value) => machine.PrintPosition(value);

    private static void PerAxis(StatementReader reader, Func<Machine, Axis, string> print)
    {
        var selection = reader.TakeAxes();
        reader.ExpectEnd();
        if (selection.Planes.Count > 0) throw new CommandRefusedException(Tc.PlaneNotValid);

        reader.Context.WriteLine(Join(selection.AxesOrAll.Select(a => print(reader.Machine, a))));
    }

    private static void StatusOfController(StatementReader reader)
    {
        reader.TryTake('?');
        reader.ExpectEnd();
        reader.Context.WriteLine(Position(reader.Machine, reader.Machine.StatusByte));
    }

    /// <summary>TC, TC 0 and TC ? give the number, TC 1 also the text; all of them clear it (A.8).</summary>
    private static void ErrorCode(StatementReader reader)
    {
        var text = !reader.IsAtEnd && !reader.TryTake('?') && reader.TakeExpression().Integer == 1;
        reader.ExpectEnd();
        var code = reader.Machine.LastError;
        reader.Machine.LastError = 0;
        var number = code.ToString(CultureInfo.InvariantCulture);
        reader.Context.WriteLine(text ? code == 0 ? " 0" : $"{number} {Tc.TextOf(code)}" : " " + number);
    }
}
