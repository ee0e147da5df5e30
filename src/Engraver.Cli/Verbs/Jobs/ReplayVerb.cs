using System.CommandLine;
using Engraver.Cli.Output;
using Engraver.Cli.Output.Jobs;
using Engraver.Core.Languages;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Cli.Verbs.Jobs;

/// <summary><c>engraver replay</c>: sends the recorded conversation of a run to a simulated controller.</summary>
internal static class ReplayVerb
{
    public static Command Build(VerbHost host)
    {
        var journal = new Argument<string>("JOURNAL") { Description = Wording.Get("Replay.JournalArgument") };
        var record = new Option<string?>("--record") { HelpName = "FILE", Description = Wording.Get("Replay.Record") };
        var against = new Option<string?>("--against") { HelpName = "FILE", Description = Wording.Get("Replay.Against") };
        var json = JsonOption.New();
        var command = new Command("replay", Wording.Get("Replay.Summary"));
        command.Arguments.Add(journal);
        foreach (var option in (Option[])[record, against, json]) command.Options.Add(option);
        command.SetAction(async (parsed, stop) =>
        {
            var file = parsed.GetRequiredValue(journal);
            VerbHost.RejectSameFile(file, parsed.GetValue(record));
            var (replay, lack) = await IncidentReplay.RunAsync(file, ConversationFile.PathOf(file), stop).ConfigureAwait(false);
            if (replay is null) throw new UsageException(Wording.Get("Replay.NotPossible", lack));
            await using var owned = replay;
            if (parsed.GetValue(record) is { } samples) host.Write(samples, replay.WriteRecord);
            var compared = parsed.GetValue(against) is { } other ? Compared(replay, other) : null;
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, ReplayJson.From(file, replay, compared), ContractJson.Default.ReplayJson);
            else WriteResult(host.Out, replay, compared);
            return replay.EndsAsJournalled == false || compared is { IsSame: false } ? ExitCode.DrawingError : ExitCode.Done;
        });
        return command;
    }

    private static void WriteResult(TextWriter output, IncidentReplay replay, ReplayComparison? compared)
    {
        if (replay.FinalPosition is { } final) output.WriteLine(Wording.Get("Replay.Done", replay.Conversation.Steps.Count, replay.Samples, replay.Seconds, final.X, final.Y));
        else output.WriteLine(Wording.Get("Replay.NothingMoved", replay.Conversation.Steps.Count));
        if (!replay.Conversation.IsWhole) output.WriteLine(Wording.Get("Replay.ConversationIncomplete"));
        if (replay.EndsAsJournalled is { } agrees) output.WriteLine(Wording.Get(agrees ? "Replay.Agrees" : "Replay.PositionDiffers", replay.JournalledJob!.End!.X, replay.JournalledJob.End.Y));
        if (replay.LateSeconds > 0.0) output.WriteLine(Wording.Get("Replay.Late", replay.LateSeconds));
        if (compared is not null) output.WriteLine(compared.IsSame ? Wording.Get("Replay.Equal", compared.MatchingLines) : Wording.Get("Replay.Differs", compared.MatchingLines, compared.RecordLine ?? "", compared.ReplayLine ?? ""));
    }

    /// <exception cref="UsageException">The record cannot be read.</exception>
    private static ReplayComparison Compared(IncidentReplay replay, string record)
    {
        try
        {
            using var input = File.OpenText(record);
            return replay.CompareWith(input);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            throw new UsageException(Wording.Get("Replay.RecordUnreadable", record, SystemErrorText.FromException(unreadable)), unreadable);
        }
    }
}
