using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Cli.Output.Jobs;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Reports;

namespace Engraver.Cli.Verbs.Jobs;

/// <summary><c>engraver history</c>: the jobs that were run and the programs that were written, on the console and in the desktop.</summary>
internal static class HistoryVerb
{
    public static Command Build(VerbHost host)
    {
        var search = new Option<string?>("--search") { HelpName = "TEXT", Description = Wording.Get("History.Search") };
        var last = new Option<double?>("--last") { HelpName = "N", Description = Wording.Get("History.Last"), CustomParser = result => OptionValue.IntegerFromOne(result) };
        var budget = new Option<double?>("--budget") { HelpName = "MB", Description = Wording.Get("History.Budget"), CustomParser = result => OptionValue.IntegerFromOne(result) };
        var json = JsonOption.New();
        var command = new Command("history", Wording.Get("History.Summary"));
        foreach (var option in (Option[])[search, last, budget, json]) command.Options.Add(option);
        command.SetAction(parsed =>
        {
            if (parsed.GetValue(budget) is { } megabytes && RunBudget.Set((int)megabytes) is { } failure) throw new UsageException(Wording.Get("History.BudgetNotSaved", failure));
            var reading = new JobHistory(JobHistory.FolderIn(null)).Refresh();
            var numbered = reading.Entries.Select((entry, index) => (Number: index + 1, Entry: entry)).Where(one => parsed.GetValue(search) is not { } word || one.Entry.Matches(word)).Take((int)(parsed.GetValue(last) ?? int.MaxValue)).ToList();
            foreach (var finding in reading.Findings) host.Error.WriteLine(finding);
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, HistoryListJson.From(numbered.Select(one => one.Entry), reading.Findings), ContractJson.Default.HistoryListJson);
            else WriteText(host, numbered);
            return ExitCode.Done;
        });
        return command;
    }

    private static void WriteText(VerbHost host, IReadOnlyList<(int Number, HistoryEntry Entry)> entries)
    {
        HistoryText.Write(host.Out, entries, TimeZoneInfo.Local);
        host.Out.WriteLine(Wording.Get("History.Size", RunBudget.UsedMegabytes, RunBudget.Megabytes));
    }
}
