using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Languages;
using Engraver.Core.Posts;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver post</c>: the job in one of the formats of the table of posts.</summary>
internal static class PostVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var target = new Option<string>("--target") { Required = true, Description = string.Join("; ", PostTable.All.Select(entry => $"{TextCatalogue.Fact(entry.Post.Name)}: {entry.Post.Summary}")) + "." };
        target.AcceptOnlyFromAmong([.. PostTable.All.Select(entry => entry.Post.Name)]);
        var output = new Option<string?>("-o", "--output") { HelpName = "OUT", Description = Wording.Get("Verbs.Output") };
        var json = JsonOption.New();
        var values = ValuesOption.New();
        var choices = PostTable.Options.Select(Choice).ToList();
        var command = new Command("post", Wording.Get("Post.Summary"));
        drawing.AddTo(command);
        command.Options.Add(target);
        command.Options.Add(output);
        command.Options.Add(json);
        command.Options.Add(values);
        foreach (var choice in choices) command.Options.Add(choice);
        command.Validators.Add(result => CheckChoices(result, target, choices));
        command.SetAction((parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            VerbHost.RejectSameFile(drawing.File(parsed), parsed.GetValue(output));
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            var chosen = choices.Where(choice => parsed.GetValue(choice) is not null).ToDictionary(NameOf, choice => parsed.GetValue(choice)!);
            var posted = PostedProgram.Create(read, settings, PostTable.Find(parsed.GetRequiredValue(target)).Post, chosen, ValuesOption.Read(parsed.GetValue(values)));
            Write(host, parsed, posted, PostTable.Find(parsed.GetRequiredValue(target)).Post.Name, parsed.GetValue(output), parsed.GetValue(json));
            if (posted.Text is not null) host.Remember(HistoryEntry.OfPost(read, settings, parsed.GetRequiredValue(target), chosen, parsed.GetValue(output), TimeProvider.System.GetUtcNow()));
            return Task.FromResult(host.Report(parsed, read.FileName, posted.Diagnostics));
        });
        return command;
    }

    /// <summary>Writes the text to its file or to standard output. The forecast goes to standard output if the text does not.</summary>
    private static void Write(VerbHost host, ParseResult parsed, PostedProgram posted, string target, string? file, bool asJson)
    {
        if (posted.Text is { } text && (file is not null || !asJson)) host.Write(file, writer => writer.Write(text));
        if (posted.Text is not null && file is not null) VerbHost.SaveProgramStart(file, posted.Forecast);
        if (asJson) ContractJson.Write(host.Out, PostJson.From(target, file, posted), ContractJson.Default.PostJson);
        else if (file is not null && posted.Forecast is { } forecast && !host.Quiet(parsed)) ForecastText.Write(host.Out, forecast);
    }

    private static Option<string?> Choice(PostOption option)
    {
        var choice = new Option<string?>("--" + option.Name) { HelpName = option.Argument, Description = Wording.Get("Post.Default", string.Join(", ", PostTable.TargetsWith(option)), option.Summary, option.Form, option.Default) };
        choice.Validators.Add(result =>
        {
            if (result.Tokens is [{ Value: var value }] && !option.IsValid(value)) result.AddError(Wording.Get("Post.InvalidOption", option.Name, value, option.Form));
        });
        return choice;
    }

    /// <summary>Refuses an option that the target does not have, instead of ignoring it.</summary>
    private static void CheckChoices(CommandResult result, Option<string> target, IEnumerable<Option<string?>> choices)
    {
        if (result.GetResult(target) is not { Tokens: [{ Value: var name }] } || PostTable.All.FirstOrDefault(entry => entry.Post.Name == name) is not { Post: var post }) return;
        foreach (var choice in choices.Where(choice => result.GetResult(choice) is not null && post.Options.All(option => option.Name != NameOf(choice))))
            result.AddError(Wording.Get("Post.OptionNotSupported", choice.Name, name));
    }

    private static string NameOf(Option<string?> choice) => choice.Name["--".Length..];
}
