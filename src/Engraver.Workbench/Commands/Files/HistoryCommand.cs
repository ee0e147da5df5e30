using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Files;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Files;

/// <summary>HISTORY: Lists runs and posted programs; opens the drawing of one, with its settings if it is to be run again.</summary>
internal sealed class HistoryCommand : ICommand
{
    /// <summary>Number of listed entries without a search.</summary>
    private const int MaxListed = 20;

    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("List", "Search", "Open", "Rerun", "rePort");

    public CommandInfo Info { get; } = new("HISTORY", CommandGroup.File) { IsAllowedDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var reading = context.History.Refresh();
        foreach (var finding in reading.Findings) context.WriteMessage(finding, MessageKind.Warning);
        var option = await context.ChoiceAsync(Wording.Get("History.EnterOption"), s_options, "List").ConfigureAwait(false);
        if (option is "List" or "Search")
        {
            var word = option == "Search" ? await context.ValueAsync(new TextPrompt(Wording.Get("History.EnterWord"))).ConfigureAwait(false) : null;
            List(context, reading, word);
            return;
        }

        if (reading.Entries.Count == 0) throw new CommandException(CommandFailure.Usage, Wording.Get("History.NoEntries"));
        var name = await context.ValueAsync(new TextPrompt(Wording.Get("History.EnterNumber"))).ConfigureAwait(false);
        var entry = reading.Find(name) ?? throw new CommandException(CommandFailure.Usage, Wording.Get("History.NoEntry", name));
        if (option == "rePort") await JobReportFile.WriteAsync(context, entry, SettingsOf(entry, context.Families), cancellation).ConfigureAwait(false);
        else Open(context, entry, option == "Rerun" ? SettingsOf(entry, context.Families) : null, cancellation);
        if (option == "Rerun" && entry.Kind == "post") await PostCommand.WriteAsync(context, PostOf(entry), entry.Options).ConfigureAwait(false);
    }

    private static void List(CommandContext context, HistorySnapshot reading, string? word)
    {
        var found = reading.Filter(word).Entries;
        if (found.Count == 0) throw new CommandException(CommandFailure.Usage, word is null ? Wording.Get("History.NoEntries") : Wording.Get("History.NothingFound", word));
        var numbered = reading.Entries.Select((entry, index) => (entry, index)).Where(one => found.Contains(one.entry)).Take(word is null ? MaxListed : int.MaxValue);
        context.WriteResult(output => HistoryText.Write(output, numbered.Select(one => (one.index + 1, one.entry)), context.Time.LocalTimeZone));
    }

    private static void Open(CommandContext context, HistoryEntry entry, DrawingSettings? settings, CancellationToken cancellation)
    {
        context.ThrowIfConcurrent();
        DrawingOpening.Open(context, entry.Drawing, entry.Drawing, cancellation, settings);
        if (entry.DrawingSha256 is { } then && ContentHash.OfFile(entry.Drawing) != then) context.WriteMessage(Wording.Get("History.DrawingChanged", Path.GetFileName(entry.Drawing)), MessageKind.Warning);
        if (settings is not null) context.WriteMessage(Wording.Get("History.SettingsRestored", HistoryText.Date(entry, context.Time.LocalTimeZone)));
        if (entry.RanTrajectories) context.WriteMessage(Wording.Get("History.RanTrajectories"), MessageKind.Warning);
    }

    /// <exception cref="CommandException">It was written in an unknown format or with an unknown option.</exception>
    private static PostEntry PostOf(HistoryEntry entry)
    {
        var post = PostTable.All.FirstOrDefault(one => one.Post.Name == entry.Target);
        var isKnown = post is not null && entry.Options.All(chosen => post.Post.Options.Any(option => option.Name == chosen.Key && option.IsValid(chosen.Value)));
        return isKnown ? post! : throw new CommandException(CommandFailure.Usage, Wording.Get("History.NoSuchPost", HistoryText.Target(entry)));
    }

    private static DrawingSettings SettingsOf(HistoryEntry entry, MachineFamilies families)
    {
        try
        {
            return entry.ToSettings(families);
        }
        catch (FormatException unfit)
        {
            throw new CommandException(CommandFailure.Usage, Wording.Get("History.SettingsInvalid", unfit.Message));
        }
    }
}
