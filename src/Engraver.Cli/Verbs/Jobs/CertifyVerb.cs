using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Cli.Output.Jobs;
using Engraver.Core.Machines;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Cli.Verbs.Jobs;

/// <summary><c>engraver certify</c>: reads the program of a job back and certifies that it matches the drawing; with <c>--check</c> it only checks whether the
/// certificate is still valid.</summary>
internal sealed class CertifyVerb
{
    private readonly VerbHost _host;
    private readonly DrawingOptions _drawing = new();
    private readonly Option<string?> _target = new("--target") { Description = Wording.Get("Certify.Target") };
    private readonly Option<string?> _dialect = new("--dialect") { HelpName = "NAME", Description = Wording.Get("Certify.Dialect") };
    private readonly Option<string?> _program = new("--program") { HelpName = "FILE", Description = Wording.Get("Certify.Program") };
    private readonly PostParameterOptions _posted = new();
    private readonly Option<string?> _output = new("-o", "--output") { HelpName = "FILE", Description = Wording.Get("Certify.Output") };
    private readonly Option<bool> _check = new("--check") { Description = Wording.Get("Certify.Check") };
    private readonly Option<ControllerAddress?> _connect = ConnectOption.New(required: false, Wording.Get("Plan.Connect"));
    private readonly Option<string> _mode = ModeOption.New();
    private readonly Option<string?> _values = ValuesOption.New();
    private readonly Option<bool> _json = JsonOption.New();

    private CertifyVerb(VerbHost host)
    {
        _host = host;
        _target.AcceptOnlyFromAmong([.. PostTable.All.Where(entry => entry.Reader is not null).Select(entry => entry.Post.Name)]);
        _dialect.AcceptOnlyFromAmong([.. PostTable.All.SelectMany(entry => entry.Dialects.Keys)]);
    }

    public static Command Build(VerbHost host)
    {
        var verb = new CertifyVerb(host);
        var command = new Command("certify", Wording.Get("Certify.Summary"));
        verb._drawing.AddTo(command);
        foreach (var option in (Option[])[verb._target, verb._dialect, verb._program, verb._output, verb._check, verb._connect, verb._mode, verb._json, verb._values]) command.Options.Add(option);
        verb._posted.AddTo(command, verb.Target);
        command.SetAction(verb.RunAsync);
        return command;
    }

    private async Task<int> RunAsync(ParseResult parsed, CancellationToken stop)
    {
        var (settings, file) = (_drawing.Settings(parsed), _drawing.File(parsed));
        VerbHost.RejectSameFile(file, parsed.GetValue(_output));
        var (strategy, hash) = (ModeOption.Strategy(parsed, _mode, settings), ContentHash.OfFile(file));
        var target = Target(parsed, settings, strategy);
        var request = new CertificationRequest(DrawingFile.Open(file, settings, stop), hash, settings, target, TimeProvider.System.GetUtcNow())
        {
            Dialect = Dialect(parsed, target),
            Program = parsed.GetValue(_program) is { } program ? Given(program) : null,
            PostParameters = Posted(parsed) with { Start = parsed.GetValue(_program) is { } started ? _host.SavedStart(parsed, started) : null },
            Address = parsed.GetValue(_connect),
            Strategy = strategy,
            Values = ValuesOption.Read(parsed.GetValue(_values)),
        };
        var place = parsed.GetValue(_output) ?? CertificateFile.PathOf(file, request.Target.Post.Name, request.Dialect);
        return parsed.GetValue(_check) ? Check(parsed, request, place) : await CertifyAsync(parsed, request, place, stop).ConfigureAwait(false);
    }

    private async Task<int> CertifyAsync(ParseResult parsed, CertificationRequest request, string place, CancellationToken stop)
    {
        if (request.DrawingHash is null && !DrawingFile.IsUnreadable(request.Drawing)) throw new UsageException(Wording.Get("Certify.NotRereadable", request.Drawing.FileName));
        var quiet = _host.Quiet(parsed) || parsed.GetValue(_json);
        var made = await ProgressBar.OfVerificationAsync(quiet, progress => Certification.CertifyAsync(request, progress, stop)).ConfigureAwait(false);
        var code = _host.Report(parsed, request.Drawing.FileName, made.Diagnostics);
        if (made.Certificate is not { } certificate)
        {
            _host.Error.WriteLine(Wording.Get("Certify.NotCertified", made.NoProgramReason));
            return ExitCode.DrawingError;
        }

        if (certificate.Ok) _host.Write(place, output => output.WriteLine(CertificateFile.Text(certificate)));
        if (request.Program is { } given) _host.NoteReadBack(given.File, new HistoryReadBack(certificate.Ok, request.Now, certificate.MaxDeviation, certificate.Ok ? Path.GetFullPath(place) : null));
        if (parsed.GetValue(_json)) _host.Out.WriteLine(CertificateFile.Text(certificate));
        else _host.Out.WriteLine(Wording.Get(certificate.Ok ? "Certify.Written" : "Certify.Deviates", place, certificate.MaxDeviation ?? 0.0, certificate.Tolerance, certificate.MissingLength, certificate.ExtraLength));
        return certificate.Ok ? code : ExitCode.DrawingError;
    }

    private int Check(ParseResult parsed, CertificationRequest request, string place)
    {
        _host.Report(parsed, request.Drawing.FileName, request.Drawing.Diagnostics);
        var standing = CertificateStatus.Of(place, Certification.IdentityOf(request));
        if (parsed.GetValue(_json)) ContractJson.Write(_host.Out, CertificateCheckJson.From(standing, place), ContractJson.Default.CertificateCheckJson);
        else _host.Out.WriteLine(SettingWording.OnConsole(standing.Message) + ".");
        return standing.State == CertificateState.Stands ? ExitCode.Done : ExitCode.DrawingError;
    }

    /// <summary>Without a target: what the machine would be sent with this strategy; the first of the table where its family has no post.</summary>
    private PostEntry Target(ParseResult parsed, DrawingSettings settings, ExecutionStrategy strategy) =>
        parsed.GetValue(_target) is { } name ? PostTable.Find(name) : PostTable.ForMotion(MachineFamilies.DriverOf(settings.Machine), strategy.Style) ?? PostTable.All[0];

    private string Target(CommandResult result) => result.GetResult(_target) is { Tokens: [var named] } ? named.Value : PostTable.All[0].Post.Name;

    /// <exception cref="UsageException">An option describes a given program but none is given: the program posted here has the defaults.</exception>
    private PostParameters Posted(ParseResult parsed)
    {
        var posted = _posted.Of(parsed);
        return posted == PostParameters.Defaults || parsed.GetValue(_program) is not null ? posted : throw new UsageException(Wording.Get("Certify.PostedWithoutProgram"));
    }

    /// <summary>Null for the default dialect of the target.</summary>
    /// <exception cref="UsageException">The target does not have it.</exception>
    private string? Dialect(ParseResult parsed, PostEntry target)
    {
        if (parsed.GetValue(_dialect) is not { } dialect) return null;
        if (!target.Dialects.ContainsKey(dialect)) throw new UsageException(Wording.Get("Post.OptionNotSupported", _dialect.Name, target.Post.Name));
        return target.Post.Options.Any(option => option.Name == "dialect" && option.Default == dialect) ? null : dialect;
    }

    /// <exception cref="UsageException">The program cannot be read.</exception>
    private static (string File, string Text) Given(string path)
    {
        var (text, fault) = ReadBackFile.Open(path).ReadAll();
        return text is not null ? (path, text) : throw new UsageException(Wording.Get("Certify.ProgramUnreadable", path, fault!.Message));
    }
}
