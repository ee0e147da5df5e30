using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Posts;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Verification;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver verify</c>: reads a posted program back, runs it in a simulated controller and compares it with the drawing.</summary>
internal sealed class VerifyVerb
{
    private readonly VerbHost _host;
    private readonly Argument<string> _program = new("PROGRAM") { Description = Wording.Get("Verify.Program") };
    private readonly Option<string> _against = new("--against") { Required = true, HelpName = "FILE", Description = Wording.Get("Verify.Against") };
    private readonly Option<string?> _target = new("--target") { Description = Wording.Get("Verify.Target") };
    private readonly Option<string?> _dialect = new("--dialect") { HelpName = "NAME", Description = Wording.Get("Verify.Dialect") };
    private readonly PostParameterOptions _posted = new();
    private readonly Option<bool> _json = JsonOption.New();
    private readonly Option<string?> _values = ValuesOption.New();
    private readonly Option<int?> _section = new("--section") { HelpName = "N", Description = Wording.Get("Verify.Section") };
    private readonly DrawingOptions _drawing = new();

    private VerifyVerb(VerbHost host)
    {
        _host = host;
        _target.AcceptOnlyFromAmong([.. PostTable.All.Where(entry => entry.Reader is not null).Select(entry => entry.Post.Name).Union(TrajectoryFormatName.All)]);
        _dialect.AcceptOnlyFromAmong([.. PostTable.All.SelectMany(entry => entry.Dialects.Keys)]);
        _section.Validators.Add(result =>
        {
            if (result.Tokens is [{ Value: var value }] && !(int.TryParse(value, out var number) && number > 0)) result.AddError(Wording.Get("Verify.InvalidSection", value));
        });
    }

    public static Command Build(VerbHost host)
    {
        var verb = new VerifyVerb(host);
        var command = new Command("verify", Wording.Get("Verify.Summary"));
        command.Arguments.Add(verb._program);
        foreach (var option in (Option[])[verb._against, verb._target, verb._dialect, verb._json, verb._values, verb._section]) command.Options.Add(option);
        verb._posted.AddTo(command, verb.Target);
        verb._drawing.AddOptionsTo(command);
        command.Validators.Add(verb.CheckDialect);
        command.SetAction(verb.RunAsync);
        return command;
    }

    private async Task<int> RunAsync(ParseResult parsed, CancellationToken stop)
    {
        var settings = _drawing.Settings(parsed);
        var drawing = DrawingFile.Open(parsed.GetRequiredValue(_against), settings, stop);
        var file = parsed.GetRequiredValue(_program);
        var (target, dialect) = parsed.GetValue(_target) is { } named ? (named, parsed.GetValue(_dialect)) : Found(file, parsed.GetValue(_dialect));
        var (program, reader) = ReadBack(file, target, dialect);
        if (parsed.GetValue(_target) is null && ProgramFormatDetector.Of(file) is null && !_host.Quiet(parsed)) await _host.Error.WriteLineAsync(Wording.Get("Verify.ReadAs", file, $"{target} {dialect}".TrimEnd())).ConfigureAwait(false);
        var posted = _posted.Of(parsed) with { Start = _host.SavedStart(parsed, file), Values = ValuesOption.Read(parsed.GetValue(_values)), Section = parsed.GetValue(_section) };
        var quiet = _host.Quiet(parsed) || parsed.GetValue(_json);
        var report = await ProgressBar.OfVerificationAsync(quiet, progress => ProgramVerification.VerifyAsync(program, reader, drawing, settings, progress, stop, posted)).ConfigureAwait(false);
        report = CertifiedFonts.Compare(report, drawing, settings, target, dialect);
        if (parsed.GetValue(_json)) ContractJson.Write(_host.Out, VerifyJson.From(report, target), ContractJson.Default.VerifyJson);
        else _host.Out.WriteLine(VerificationText.Sentence(report));
        _host.Report(parsed, drawing.FileName, drawing.Diagnostics);
        _host.Report(parsed, file, report.Diagnostics);
        _host.NoteReadBack(file, new HistoryReadBack(report.Ok, TimeProvider.System.GetUtcNow(), report.MaxDeviationMm, Certificate: null));
        return report.Ok ? ExitCode.Done : ExitCode.DrawingError;
    }

    private static (ReadBackFile Program, IProgramReader Reader) ReadBack(string path, string target, string? dialect) => TrajectoryFormatName.All.Contains(target)
        ? (TrajectoryReadBack.Open(path), TrajectoryReadBack.ReaderOf(TrajectoryFormatName.Parse(target)))
        : (ReadBackFile.Open(path), dialect is null ? PostTable.Find(target).Reader! : PostTable.Find(target).Dialects[dialect]);

    /// <summary>Refuses a dialect that the target does not have, instead of ignoring it.</summary>
    private void CheckDialect(CommandResult result)
    {
        if (result.GetResult(_dialect) is not { Tokens: [var dialect] }) return;
        if (Entry(result)?.Dialects.ContainsKey(dialect.Value) != true) result.AddError(Wording.Get("Post.OptionNotSupported", _dialect.Name, Target(result)));
    }

    private string Target(CommandResult result) => result.GetResult(_target) is { Tokens: [var named] } ? named.Value
        : result.GetResult(_program) is { Tokens: [var file] } ? Found(file.Value, null).Target : PostTable.All[0].Post.Name;

    /// <summary>The detected format of the file; the first entry of the table if it is not recognised.</summary>
    /// <param name="asked">The dialect from the command line; null: from the file.</param>
    private static (string Target, string? Dialect) Found(string file, string? asked) => ProgramFormatDetector.Of(file) is { } found ? (found.Entry.Post.Name, asked ?? found.Dialect) : (PostTable.All[0].Post.Name, asked);

    /// <summary>Null for a target of trajectories.</summary>
    private PostEntry? Entry(CommandResult result) => PostTable.All.FirstOrDefault(entry => entry.Post.Name == Target(result));
}
