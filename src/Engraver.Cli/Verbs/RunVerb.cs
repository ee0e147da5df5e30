using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Cli.Terminals;
using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver run</c>: runs a drawing on a controller.</summary>
internal sealed class RunVerb
{
    /// <summary>Refusals that result from the machine's state or abilities; the others result from a setting.</summary>
    private static readonly DiagnosticRule[] s_machineRules = [PreparationRules.OutsideTravel, PreparationRules.HeightOutsideTravel, PreparationRules.DryRunOutsideTravel, PreparationRules.NotHomed];

    private const string Name = "run";

    private readonly VerbHost _host;
    private readonly DrawingOptions _drawing = new();
    private readonly Option<ControllerAddress?> _connect = ConnectOption.New(required: true, Wording.Get("Run.Connect"));
    private readonly Option<string> _mode = ModeOption.New();
    private readonly Option<bool> _json = JsonOption.New();
    private readonly Option<string?> _journal = new("--journal") { HelpName = "FILE", Description = Wording.Get("Run.Journal") };
    private readonly Option<bool> _dryRun = new("--dry-run") { Description = Wording.Get("Run.DryRun") };
    private readonly PlacementOptions _placement = new();
    private readonly Option<string?> _trace = new("--trace") { HelpName = "FILE", Description = Wording.Get("Run.Trace") };
    private readonly Option<bool> _acceptErrors = new("--accept-errors") { Description = Wording.Get("Run.AcceptErrors") };

    private readonly Option<string?> _resume = new("--resume") { HelpName = "JOURNAL", Description = Wording.Get("Run.Resume") };
    private readonly Option<bool> _trajectory = new("--trajectory") { Description = Wording.Get("Run.Trajectory") };
    private readonly Option<double> _leadIn = new("--lead-in") { HelpName = "MM", Description = Wording.Get("Run.LeadIn"), DefaultValueFactory = _ => ResumeRequest.DefaultLeadInMm, CustomParser = ParseLeadIn };

    /// <summary>Settings for the <c>--json</c> object of a run that did not start, as far as they are known.</summary>
    private DrawingSettings _settings = new();
    private PreparedJob? _job;
    private bool _isReported;

    /// <summary>The trajectories to run; null for a job of the drawing itself.</summary>
    private TrajectoryJob? _followed;

    private RunVerb(VerbHost host) => _host = host;

    public static Command Build(VerbHost host)
    {
        var verb = new RunVerb(host);
        var command = new MachineCommand(Name, Wording.Get("Run.Summary"));
        verb._drawing.AddTo(command);
        foreach (var option in (Option[])[verb._connect, verb._mode, verb._json, verb._journal, verb._dryRun, verb._trace, verb._acceptErrors, verb._resume, verb._leadIn, verb._trajectory]) command.Options.Add(option);
        verb._placement.AddTo(command);
        command.SetAction(verb.RunAsync);
        return command;
    }

    /// <summary>Prints the object of <c>--json</c> also for unusable arguments.</summary>
    public static void ReportUnusable(ParseResult parsed, TextWriter output)
    {
        if (parsed.CommandResult.Command.Name != Name || !parsed.Tokens.Any(token => token.Value == JsonOption.Name)) return;
        ContractJson.Write(output, RunReport.NotStarted(new DrawingSettings(), null, JobOutcome.Refused), ContractJson.Default.RunJson);
        output.Flush();
    }

    /// <summary>With <c>--json</c> the object is printed whatever the outcome.</summary>
    private async Task<int> RunAsync(ParseResult parsed, CancellationToken stop)
    {
        try
        {
            return await RunJobAsync(parsed, stop).ConfigureAwait(false);
        }
        catch (Exception ended) when (parsed.GetValue(_json) && !_isReported)
        {
            await ReportNotStartedAsync(ended switch { MachineUnavailableException => JobOutcome.Refused, ControllerException => JobOutcome.LinkLost, OperationCanceledException => JobOutcome.Stopped, _ => JobOutcome.Refused }).ConfigureAwait(false);
            throw;
        }
    }

    private async Task<int> RunJobAsync(ParseResult parsed, CancellationToken stop)
    {
        var settings = _settings = _drawing.Settings(parsed);
        var strategy = ModeOption.Strategy(parsed, _mode, settings);
        if (settings is { Finish: FinishPlace.Park, Machine.Park: null }) throw new SettingException(Wording.Get("Placement.NoPark"));
        var (job, fit) = await PrepareAsync(parsed, settings, strategy, stop).ConfigureAwait(false);
        if (!parsed.GetValue(_json) && !_host.Quiet(parsed) && parsed.GetValue(_resume) is null && !parsed.GetValue(_trajectory) && await TextQuestion.AskAsync(_host, job, stop).ConfigureAwait(false) is { } engraving)
        {
            (job, fit) = await PrepareAsync(parsed, _settings = engraving, strategy, stop).ConfigureAwait(false);
        }

        _job = job;
        var code = _host.Report(parsed, job.Drawing.FileName, job.Diagnostics);
        if (_followed is { } followed && !parsed.GetValue(_json)) _host.Out.WriteLine(Wording.Get("Run.Trajectories", followed.Trajectories.Count, followed.Trajectories.Sum(one => one.Curve.Points), followed.Bound));
        if (job.Motion.Program is not { } program || (code != ExitCode.Done && !parsed.GetValue(_acceptErrors)))
        {
            return ReportNotStarted(parsed, job, NotStartedReason(job));
        }

        if (fit is null || program.SegmentCount == 0) return ReportNotStarted(parsed, job, job.NoProgramReason);
        var ended = await RunOnMachineAsync(parsed, job, fit, strategy, stop).ConfigureAwait(false);

        // Accepted errors still count as errors: the job was done as far as possible (docs/pipeline.md).
        return ended == ExitCode.Done ? code : ended;
    }

    /// <summary>Computes everything up to the machine; a stop does not wait for it.</summary>
    /// <returns>The program with feeds limited to the link; null when there is none.</returns>
    private async Task<(PreparedJob Job, LinkFeedFit? Fit)> PrepareAsync(ParseResult parsed, DrawingSettings settings, ExecutionStrategy strategy, CancellationToken stop)
    {
        var (file, address) = (_drawing.File(parsed), parsed.GetRequiredValue(_connect)!);
        return await StoppableVerb.ComputeAsync(
            () =>
            {
                var (drawing, style) = (DrawingFile.Open(file, settings, stop), strategy.Style);
                var job = parsed.GetValue(_trajectory) ? Follow(TrajectoryJob.Prepare(drawing, settings, style)) : JobPreparation.Prepare(drawing, settings, style);
                return (job, job.Motion.Program is { } program ? JobPlan.FitToLink(program, address, strategy, job.Drawing) : null);
            },
            stop).ConfigureAwait(false);
    }

    /// <summary>Mentions that errors can be accepted only if there is something to run.</summary>
    private static string NotStartedReason(PreparedJob job)
    {
        if (DrawingFile.IsUnreadable(job.Drawing)) return Wording.Get("Run.DrawingUnreadable");
        return job.Motion.Program is null ? job.NoProgramReason : Wording.Get("Run.DrawingHasErrors");
    }

    private PreparedJob Follow(TrajectoryJob followed) => (_followed = followed).Job;

    private async Task ReportNotStartedAsync(JobOutcome outcome)
    {
        Write(RunReport.NotStarted(_settings, _job, outcome));
        await _host.Out.FlushAsync(CancellationToken.None).ConfigureAwait(false);
    }

    private async Task<int> RunOnMachineAsync(ParseResult parsed, PreparedJob job, LinkFeedFit fit, ExecutionStrategy strategy, CancellationToken stop)
    {
        var control = new JobControl();
        ArmingChecklist? checks = null;
        var certificate = CertificateStatus.OfRun(job, fit.Program);
        var options = new MachineRunOptions(parsed.GetRequiredValue(_connect)!, strategy)
        {
            Control = control,
            Resume = parsed.GetValue(_resume) is { } interrupted ? new ResumeRequest { Journal = interrupted, LeadInMm = parsed.GetValue(_leadIn), AtOrigin = _placement.RequestsWorkOrigin(parsed) } : null,
            JournalPath = parsed.GetValue(_journal) ?? JournalFolder.NewJournal(job.Drawing.FileName, TimeProvider.System),
            TracePath = parsed.GetValue(_trace),
            DryRun = parsed.GetValue(_dryRun),
            Origin = _placement.Origin(parsed),
            Finish = job.Settings.Finish,
            Memories = PlacementOptions.Memories(parsed.GetRequiredValue(_connect)!),
            LeaseOwner = PlacementOptions.OwnerName,
            CheckStart = (status, placement) =>
            {
                checks = ArmingChecklist.ForConsole(job, placement.Program.Profile, status, placement.Found, certificate.Check);
                if (!parsed.GetValue(_json)) _host.Print(parsed, checks);
                return status.State == MachineState.Busy ? null : checks.FailureText; // The job checks more closely and reports what is running.
            },
            FindingReported = finding => _host.Report(parsed, job.Drawing.FileName, [finding]),
        };
        var quiet = _host.Quiet(parsed) || parsed.GetValue(_json);
        CheckWritable(options.JournalPath);
        if (options.TracePath is { } trace) CheckWritable(trace);
        _host.Report(parsed, job.Drawing.FileName, fit.Diagnostics);
        var begun = TimeProvider.System.GetUtcNow();
        using var open = _host.BeginRun(HistoryEntry.OfStarted(job, options, begun, simulated: false));
        MachineRunReport report;
        try
        {
            var lines = new LineQueue(_host.Error.WriteLine);
            await using var written = lines.ConfigureAwait(false);
            report = await ProgressBar.OfRunAsync(quiet, fit.Program, progress => MachineRun.RunAsync(job, fit.Program, options, TimeProvider.System, WithKeys(control, job.Settings.Machine.Scale, lines, progress), stop)).ConfigureAwait(false);
        }
        catch (ControllerException lost) // The link could not be established.
        {
            open.End(HistoryEntry.OfLost(job, options, lost.Message, begun));
            throw;
        }

        open.End(HistoryEntry.OfRun(job, options, report, begun, simulated: false, checks));
        return Finish(parsed, job, report, options.JournalPath, checks);
    }

    private static double ParseLeadIn(ArgumentResult result)
    {
        if (NumberPrompt.TryParse(result.Tokens[0].Value, out var length) && length is >= 0.0 and <= ResumeRequest.MaxLeadInMm) return length;
        result.AddError(Wording.Get("Run.InvalidLeadIn", result.Tokens[0].Value, ResumeRequest.MaxLeadInMm));
        return ResumeRequest.DefaultLeadInMm;
    }

    /// <summary>On an interactive terminal, shows the keys and polls them with every progress report.</summary>
    private IProgress<JobProgress>? WithKeys(JobControl control, CountsScale scale, LineQueue lines, IProgress<JobProgress>? progress)
    {
        if (_host.Keys is not { } next) return progress;
        _host.Error.WriteLine(Wording.Get("RunKeys.Help"));
        return new BothProgress(new RunKeys(control, scale, next, lines.Enqueue), progress);
    }

    private sealed class BothProgress(IProgress<JobProgress> first, IProgress<JobProgress>? second) : IProgress<JobProgress>
    {
        public void Report(JobProgress value)
        {
            first.Report(value);
            second?.Report(value);
        }
    }

    private int Finish(ParseResult parsed, PreparedJob job, MachineRunReport report, string journal, ArmingChecklist? checks)
    {
        _host.Report(parsed, job.Drawing.FileName, report.Result.Diagnostics);
        if (report.ResumeRefusal is { } unresumed) return ReportNotPlaced(parsed, job, unresumed, checks);
        if (report.Placement?.Refusal is { } unplaced) return ReportNotPlaced(parsed, job, unplaced, checks);
        if (parsed.GetValue(_json)) Write(RunReport.Json(job, report, journal, checks) with { Trajectory = RunJson.FollowedJson.From(_followed) });
        else _host.Out.WriteLine(RunText.Sentence(job, report, SettingWording.OnConsole));
        if (report.Result.Outcome != JobOutcome.Complete) _host.Error.WriteLine($"engraver: {report.Result.Message}");
        if (report.TraceFailure is { } failure) _host.Error.WriteLine(Wording.Get("Run.TraceIncomplete", failure));
        foreach (var left in report.Result.NotRestored) _host.Error.WriteLine(Wording.Get("Run.NotRestored", left));
        return ExitCode.Of(report.Result.Outcome);
    }

    private void Write(RunJson report)
    {
        _isReported = true;
        ContractJson.Write(_host.Out, report, ContractJson.Default.RunJson);
    }

    /// <summary>The work origin is unknown: nothing was moved.</summary>
    private int ReportNotPlaced(ParseResult parsed, PreparedJob job, Diagnostic refusal, ArmingChecklist? checks)
    {
        _host.Report(parsed, job.Drawing.FileName, [refusal]);
        if (parsed.GetValue(_json)) Write(RunReport.NotStarted(job.Settings, job, JobOutcome.Refused, checks));
        return s_machineRules.Contains(refusal.Rule) ? ExitCode.DrawingError : ExitCode.Usage;
    }

    private int ReportNotStarted(ParseResult parsed, PreparedJob job, string why)
    {
        if (parsed.GetValue(_json)) Write(RunReport.NotStarted(job.Settings, job, JobOutcome.Refused));
        _host.Error.WriteLine(Wording.Get("Run.NotStarted", why));
        return ExitCode.DrawingError;
    }

    /// <summary>Called before anything is sent: a job whose journal cannot be written must not start. A pipe is not tested, because its reader would take the
    /// end of the test for the end of the file.</summary>
    /// <exception cref="UsageException">The file cannot be written.</exception>
    private static void CheckWritable(string path)
    {
        if (FileKind.IsStream(path)) return;
        try
        {
            using var file = File.Open(path, FileMode.OpenOrCreate, FileAccess.Write);
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            throw new UsageException(Wording.Get("Verbs.CannotWrite", path, SystemErrorText.FromException(unwritable)), unwritable);
        }
    }
}
