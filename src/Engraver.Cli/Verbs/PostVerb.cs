using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Drawings;
using Engraver.Core.Languages;
using Engraver.Core.Posts;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

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
            var (post, file, plate) = (PostTable.Find(parsed.GetRequiredValue(target)).Post, parsed.GetValue(output), ValuesOption.Read(parsed.GetValue(values)));
            var programs = (file is null ? parsed.GetValue(json) : !FileKind.IsStream(file)) ? ToolProgram.Of(read, settings, post, chosen, plate) : [];
            if (programs.Count > 0) return Task.FromResult(WriteAll(host, parsed, new PostRun(read, settings, post.Name, chosen), programs, file, parsed.GetValue(json)));
            var posted = PostedProgram.Create(read, settings, post, chosen, plate);
            Write(host, parsed, posted, post.Name, file, parsed.GetValue(json));
            if (posted.Text is not null) host.Remember(HistoryEntry.OfPost(read, settings, post.Name, chosen, file, TimeProvider.System.GetUtcNow()));
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

    /// <summary>Writes the program of each tool to a file of its own; none of them where one cannot be written.</summary>
    private static int WriteAll(VerbHost host, ParseResult parsed, PostRun run, IReadOnlyList<ToolProgram> programs, string? file, bool asJson)
    {
        var isWritten = programs.All(program => program.Posted.Text is not null);
        foreach (var program in isWritten && file is not null ? programs : [])
        {
            var own = program.FileOf(file!);
            VerbHost.RejectSameFile(run.Drawing.FileName, own);
            host.Write(own, writer => writer.Write(program.Posted.Text));
            host.Remember(HistoryEntry.OfPost(run.Drawing, run.Settings with { Tool = program.Tool.Number }, run.Target, run.Options, own, TimeProvider.System.GetUtcNow()));
        }

        if (asJson) ContractJson.Write(host.Out, PostJson.From(run.Target, isWritten ? file : null, isWritten ? programs : []), ContractJson.Default.PostJson);
        else if (isWritten && !host.Quiet(parsed)) foreach (var program in programs) host.Out.WriteLine(Wording.Get("Post.ToolFile", program.FileOf(file!), program.Tool.Title));
        return host.Report(parsed, run.Drawing.FileName, [.. programs.SelectMany(program => program.Posted.Diagnostics).DistinctBy(finding => (finding.Rule, finding.Source, finding.Sentence))]);
    }

    /// <param name="Options">Those of the post by name.</param>
    private sealed record PostRun(Drawing Drawing, DrawingSettings Settings, string Target, IReadOnlyDictionary<string, string> Options);

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
