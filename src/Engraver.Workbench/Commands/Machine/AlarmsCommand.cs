using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines.Alarms;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>ALARMS: Lists the alarms, or acknowledges one or all. Acknowledging resets nothing.</summary>
internal sealed class AlarmsCommand : ICommand
{
    public CommandInfo Info { get; } = new("ALARMS", CommandGroup.Machine) { IsTransparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var alarms = context.Machine.Alarms;
        var prompt = new NumberPrompt(Wording.Get("Alarms.EnterNumber")) { Options = Keyword.List("?", "All", "History"), Default = "?", Min = 1, Max = int.MaxValue, IsInteger = true };
        switch (await context.AskAsync(prompt).ConfigureAwait(false))
        {
            case Answer<double>.Value { Result: var number }:
                if (!alarms.Acknowledge((int)number)) throw new CommandException(CommandFailure.Usage, Wording.Get("Alarms.NoSuchAlarm", number));
                break;
            case Answer<double>.SelectedOption { Option: "All" }:
                context.WriteMessage(Wording.Get("Alarms.Acknowledged", alarms.AcknowledgeAll()));
                break;
            case Answer<double>.SelectedOption { Option: var option }:
                List(context, option == "History" ? alarms.All : alarms.Open);
                break;
        }
    }

    private static void List(CommandContext context, IReadOnlyList<Alarm> alarms)
    {
        if (alarms.Count == 0) context.WriteMessage(Wording.Get("Alarms.NoAlarms"));
        else context.WriteResult(output => Write(alarms, output));
    }

    private static void Write(IReadOnlyList<Alarm> alarms, TextWriter output)
    {
        foreach (var alarm in alarms)
        {
            var state = new List<string> { Wording.Get("AlarmState." + alarm.State) };
            if (alarm.IsFirstOut) state.Add(Wording.Get("Alarms.First"));
            if (alarm.Count > 1) state.Add(Wording.Get("Alarms.Times", alarm.Count));
            output.WriteLine(Wording.Get("Alarms.Row", alarm.Number, alarm.Time, string.Join(", ", state), alarm.What, alarm.Where, alarm.ToDo));
        }
    }
}
