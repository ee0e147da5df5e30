using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Cli.Output.Jobs;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Cli.Verbs.Plates;

/// <summary><c>engraver counters</c>: the counters of serial texts, and the plates that were started and not finished.</summary>
internal static class CountersVerb
{
    public static Command Build(VerbHost host)
    {
        var counter = CounterRequest.NewSettingOption();
        var json = JsonOption.New();
        var command = new Command("counters", Wording.Get("Counters.Summary"));
        foreach (var option in (Option[])[counter, json]) command.Options.Add(option);
        command.SetAction(async (parsed, stop) =>
        {
            var book = CounterBook.OfOperator(TimeProvider.System);
            try
            {
                foreach (var (name, value) in (parsed.GetValue(counter) ?? CounterRequest.None).Values)
                {
                    if (await book.SetAsync(name, value, stop).ConfigureAwait(false) is { } warning) host.Report(parsed, name, [warning]);
                }

                var state = book.Read();
                if (parsed.GetValue(json)) ContractJson.Write(host.Out, CounterListJson.From(state), ContractJson.Default.CounterListJson);
                else WriteText(host.Out, state);
                return ExitCode.Done;
            }
            catch (CounterException refused) when (refused.Finding is { } finding)
            {
                throw new UsageException($"{finding.Id}: {finding.Message}", refused);
            }
        });
        return command;
    }

    private static void WriteText(TextWriter output, CounterState state)
    {
        if (state.Counters.Count == 0) output.WriteLine(Wording.Get("Counters.None"));
        foreach (var counter in state.Counters) output.WriteLine(Wording.Get("Counters.Line", counter.Name, counter.Next));
        foreach (var plate in state.Plates) output.WriteLine(Wording.Get(plate.IsLeftOut ? "Counters.LeftOut" : "Counters.NotFinished", plate.Values, plate.Date.ToLocalTime(), plate.Drawing, plate.Journal));
    }
}
