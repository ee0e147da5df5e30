using System.Globalization;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Handles, routing of messages, data record setting (galil-dmc.md A.1, A.5, A.9).</summary>
internal static class LinkCommands
{
    private const int MinPeriod = 8;
    private const int LongestPeriod = 30000;

    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("WH", CommandScope.Host, r => r.Context.WriteLine(r.Context.Handle!.Name)),
        new("TH", CommandScope.Both, ReportHandles),
        new("IH", CommandScope.Both, CloseHandles, TakesLetter: true),
        new("CF", CommandScope.Both, ConfigureMessages),
        new("CW", CommandScope.Both, MarkMessages),
        new("DR", CommandScope.Both, DataRecordRate),
        new("EO", CommandScope.Host, Echo),
    ];

    private static void ReportHandles(StatementReader reader)
    {
        reader.ExpectEnd();
        reader.Context.WriteLine($"CONTROLLER IP ADDRESS {reader.Machine.Options.Address.ToString().Replace('.', ',')} ETHERNET ADDRESS 00-50-4C-08-01-1F");
        var handles = reader.Machine.Handles;
        for (var i = 0; i < handles.Capacity; i++)
        {
            var name = "IH" + (char)('A' + i);
            reader.Context.WriteLine(handles[i] is { } handle
                ? string.Create(CultureInfo.InvariantCulture, $"{name} {(handle.IsUdp ? "UDP" : "TCP")} PORT {handle.LocalPort} TO IP ADDRESS 127,0,0,1 PORT {handle.RemotePort}")
                : name + " AVAILABLE");
        }
    }

    /// <summary>IHT closes the other handles, IHS the sender's handle, IHA to IHH the named handle; written =&gt;-3 or =-3, types -1 UDP, -2 TCP, -3 any
    /// (A.1).</summary>
    private static void CloseHandles(StatementReader reader)
    {
        var which = reader.TakeCharacter();
        reader.Take('=', Tc.OperandError);
        reader.TryTake('>');
        var type = reader.TakeExpression().Integer;
        reader.ExpectEnd();
        AxisParameters.InRange(type, -3, -1);
        var own = reader.Context.Handle;
        var handles = reader.Machine.Handles;
        if (which is not ('T' or 'S' or (>= 'A' and <= 'H'))) throw new CommandRefusedException(Tc.OperandError);

        foreach (var handle in handles.Open.Where(h => which switch { 'T' => h != own, 'S' => h == own, _ => h.Index == which - 'A' }).ToArray())
        {
            if (type == -3 || handle.IsUdp == (type == -1)) handle.CloseWhenAnswered(handle == own);
        }
    }

    private static void ConfigureMessages(StatementReader reader)
    {
        var port = reader.TakeCharacter();
        reader.ExpectEnd();
        if (port == 'I')
            port = reader.Context.Handle is { } handle ? (handle.IsSerial ? 'S' : (char)('A' + handle.Index)) : throw new CommandRefusedException(Tc.NotInProgram);

        var known = port == 'S' || (port >= 'A' && port < 'A' + reader.Machine.Handles.Capacity);
        reader.Machine.Messages.Port = known ? port : throw new CommandRefusedException(Tc.OperandError);
    }

    /// <summary>EO 1 echoes characters received on the serial port; the command is accepted there only (A.2).</summary>
    private static void Echo(StatementReader reader)
    {
        var field = reader.TakeFields()[0];
        reader.ExpectEnd();
        if (reader.Context.Handle is not { IsSerial: true }) throw new CommandRefusedException(Tc.Unrecognized);
        if (field.IsQuery) reader.Context.WriteLine(reader.Machine.Serial.Echo ? " 1" : " 0");
        else reader.Machine.Serial.Echo = AxisParameters.InRange(field.Value?.Integer ?? 0, 0, 1) == 1;
    }

    /// <summary>CW 1 sets bit 7 of messages, CW 2 does not; the second field sets the behaviour of a blocked serial port.</summary>
    private static void MarkMessages(StatementReader reader)
    {
        var fields = reader.TakeFields();
        reader.ExpectEnd();
        var messages = reader.Machine.Messages;
        switch (fields[0].Value?.Integer)
        {
            case null or 0 when fields.Count == 1:
                reader.Context.WriteLine("GALIL MOTION CONTROL (simulated)");
                return;
            case 1 or 2:
                messages.Marking = fields[0].Value!.Value.Integer;
                break;
            case not null:
                throw new CommandRefusedException(Tc.OutOfRange);
        }

        messages.WhenBlocked = fields.ElementAtOrDefault(1).Value?.Integer ?? messages.WhenBlocked;
    }

    /// <summary>DR n,h: a record every n samples, 8 at least, to UDP handle h or, without h, to the handle that CF names (A.9). DR 0 stops.</summary>
    private static void DataRecordRate(StatementReader reader)
    {
        var fields = reader.TakeFields();
        reader.ExpectEnd();
        var machine = reader.Machine;
        var period = (int)AxisParameters.InRange(fields[0].Value?.Integer ?? throw new CommandRefusedException(Tc.NotEnoughFields), 0, LongestPeriod);
        if (period == 0)
        {
            machine.Records.Stop();
            return;
        }

        var index = fields.ElementAtOrDefault(1).Value?.Integer ?? machine.Messages.Port - 'A';
        if (index < 0 || index >= machine.Handles.Capacity || machine.Handles[index] is not { IsUdp: true }) throw new CommandRefusedException(Tc.MustBeUdp);
        AxisParameters.InRange(period, MinPeriod, LongestPeriod);
        machine.Records.Start(period, index);
    }
}
