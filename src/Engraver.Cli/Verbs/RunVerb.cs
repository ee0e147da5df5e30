using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Cli.Terminals;
using Engraver.Cli.Verbs.Plates;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
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
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver run</c>: runs a drawing on a controller.</summary>
internal sealed class RunVerb
{
    /// <summary>Refusals that result from the machine's state or abilities; the others result from a setting.</summary>
    private static readonly DiagnosticRule[] s_machineRules = [PreparationRules.OutsideTravel, PreparationRules.HeightOutsideTravel, PreparationRules.DryRunOutsideTravel, PreparationRules.NotHomed];

    private const string Name = "run";

    /// <summary>Values of --tool-change.</summary>
    private const string Ask = "ask";
    private const string Stop = "stop";

    private readonly VerbHost _host;
    private readonly DrawingOptions _drawing = new();
    private readonly Option<ControllerAddress?> _connect = ConnectOption.New(required: true, Wording.Get("Run.Connect"));
    private readonly Option<string> _mode = ModeOption.New();
    private readonly Option<bool> _json = JsonOption.New();
    private readonly Option<string?> _journal = new("--journal") { HelpName = "FILE", Description = Wording.Get("Run.Journal") };
    private readonly Option<bool> _dryRun = new("--dry-run") { Description = Wording.Get("Run.DryRun") };
    private readonly PlacementOptions _placement = new();
    private readonly SeriesOptions _series = new();
    private readonly Option<string?> _trace = new("--trace") { HelpName = "FILE", Description = Wording.Get("Run.Trace") };
    private readonly Option<bool> _acceptErrors = new("--accept-errors") { Description = Wording.Get("Run.AcceptErrors") };

    private readonly Option<string?> _toolChange = new("--tool-change") { HelpName = "ask|stop", Description = Wording.Get("Run.ToolChange") };

    private readonly Option<string?> _resume = new("--resume") { HelpName = "JOURNAL", Description = Wording.Get("Run.Resume") };
    private readonly Option<bool> _trajectory = new("--trajectory") { Description = Wording.Get("Run.Trajectory") };
    private readonly Option<double> _leadIn = new("--lead-in") { HelpName = "MM", Description = Wording.Get("Run.LeadIn"), DefaultValueFactory = _ => ResumeRequest.DefaultLeadInMm, CustomParser = ParseLeadIn };

    /// <summary>Settings for the <c>--json</c> object of a run that did not start, as far as they are known.</summary>
    private DrawingSettings _settings = new();
    private PreparedJob? _job;
    private RunJson? _report;
    private bool _isPrinted;

    /// <summary>Journal of the last run; null if that run did not start.</summary>
    private string? _startedJournal;

    /// <summary>The run is one of several plates, which have been run so far.</summary>
    private bool _isSeries;

    /// <summary>The plates after the first one, until it has started.</summary>
    private FollowingJobs? _following;
    private readonly List<PlateReportJson> _plates = [];

    /// <summary>Findings of the drawing are the same on every plate.</summary>
    private readonly HashSet<(SourceRef Source, string Message)> _reported = [];

    /// <summary>The last run ended for a change of the tool or a stop.</summary>
    private bool _isAtSectionEnd;

    /// <summary>Number of the tool with which the last plate ended; null before, and without operations.</summary>
    private int? _lastTool;

    /// <summary>The series ended before a plate that begins with another tool.</summary>
    private bool _needsOtherTool;

    /// <summary>The trajectories to run; null for a job of the drawing itself.</summary>
    private TrajectoryJob? _followed;

    private RunVerb(VerbHost host) => _host = host;

    public static Command Build(VerbHost host)
    {
        var verb = new RunVerb(host);
        verb._toolChange.AcceptOnlyFromAmong(Ask, Stop);
        var command = new MachineCommand(Name, Wording.Get("Run.Summary"));
        verb._drawing.AddTo(command);
        foreach (var option in (Option[])[verb._connect, verb._mode, verb._json, verb._journal, verb._dryRun, verb._trace, verb._acceptErrors, verb._resume, verb._leadIn, verb._trajectory, verb._toolChange]) command.Options.Add(option);
        verb._placement.AddTo(command);
        verb._series.AddTo(command);
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
            var code = await RunJobAsync(parsed, stop).ConfigureAwait(false);
            if (parsed.GetValue(_json)) Print(_report!);
            return code;
        }
        catch (Exception ended) when (parsed.GetValue(_json) && !_isPrinted)
        {
            Print(RunReport.NotStarted(_settings, _job, ended switch { MachineUnavailableException => JobOutcome.Refused, ControllerException => JobOutcome.LinkLost, OperationCanceledException => JobOutcome.Stopped, _ => JobOutcome.Refused }));
            await _host.Out.FlushAsync(CancellationToken.None).ConfigureAwait(false);
            throw;
        }
    }

    private async Task<int> RunJobAsync(ParseResult parsed, CancellationToken stop)
    {
        var settings = _settings = _drawing.Settings(parsed);
        var strategy = ModeOption.Strategy(parsed, _mode, settings);
        if (settings is { Finish: FinishPlace.Park, Machine.Park: null }) throw new SettingException(Wording.Get("Placement.NoPark"));
        if (parsed.GetValue(_trajectory) && _series.Requested(parsed) is { } several) throw new UsageException(Wording.Get("Series.NotWithTrajectory", several));
        _series.RejectSeveralTools(parsed, settings);
        var file = _drawing.File(parsed);
        var drawing = await StoppableVerb.ComputeAsync(() => DrawingFile.Open(file, settings, stop), stop).ConfigureAwait(false);
        var asksForTexts = !parsed.GetValue(_json) && !_host.Quiet(parsed) && parsed.GetValue(_resume) is null && !parsed.GetValue(_trajectory);
        if (asksForTexts && await TextQuestion.AskAsync(_host, drawing, settings, stop).ConfigureAwait(false)) _settings = settings = settings with { Cut = settings.Cut | CutChoice.Text };
        var fields = parsed.GetValue(_trajectory) ? PlateFields.Of([]) : JobPreparation.FieldsOf(drawing, settings);
        if (fields.Any || _series.Requested(parsed) is not null) return await RunSeriesAsync(parsed, drawing, settings, strategy, fields, stop).ConfigureAwait(false);
        var (machine, findings) = await RunPlateAsync(parsed, drawing, settings, strategy, null, stop).ConfigureAwait(false);

        // Accepted errors still count as errors: the job was done as far as possible (docs/pipeline.md).
        return machine == ExitCode.Done ? findings : machine;
    }

    /// <summary>Runs the plates one after the other; ends at the first that is not complete.</summary>
    private async Task<int> RunSeriesAsync(ParseResult parsed, Drawing drawing, DrawingSettings settings, ExecutionStrategy strategy, PlateFields fields, CancellationToken stop)
    {
        string? remaining = null;
        try
        {
            var (plan, findings) = await SeriesPlan.ReadAsync(parsed, _series, drawing, fields, parsed.GetValue(_dryRun), parsed.GetValue(_resume), stop).ConfigureAwait(false);
            var code = _host.Report(parsed, _series.CsvFile(parsed) ?? drawing.FileName, findings);
            if (plan is null || code != ExitCode.Done) return ReportNotStarted(null, Wording.Get("Series.NotReady"));
            RejectForSeveral(parsed, plan);
            code = _host.Report(parsed, drawing.FileName, plan.Findings);
            if (code != ExitCode.Done) return ReportNotStarted(null, Wording.Get("Series.NotReady"));
            if (!_host.Quiet(parsed) && (plan.Count > 1 || plan.First > 0)) plan.Write(_host.Error);
            if (!await LettersAreGoodAsync(parsed, drawing, settings, plan, stop).ConfigureAwait(false)) return ReportNotStarted(null, Wording.Get("Run.DrawingHasErrors"));
            _isSeries = plan.Count > 1;
            _following = await StoppableVerb.ComputeAsync(() => plan.Following(drawing, settings, strategy.Style, stop), stop).ConfigureAwait(false);
            for (var index = plan.First; index < plan.End; index++)
            {
                if (index > plan.First && plan.Series.StartsBlank(index) && !await plan.AskForBlankAsync(_host, index, stop).ConfigureAwait(false))
                {
                    Keep(RunReport.NotStarted(settings, null, JobOutcome.Stopped), null);
                    return ExitCode.StoppedByOperator;
                }

                if (index > plan.First) _following = null; // all are inside: this was checked before the first
                remaining = index > plan.First ? plan.InterruptedText(index, null) : null;
                using var turn = plan.Turn(index);
                var (machine, errors) = await RunPlateOfSeriesAsync(parsed, drawing, settings, strategy, turn, remaining, stop).ConfigureAwait(false);
                await _host.Out.FlushAsync(CancellationToken.None).ConfigureAwait(false); // the line of a plate is read before the next blank is placed
                code = Math.Max(code, errors);
                if (machine == ExitCode.Done && !_isAtSectionEnd && !_needsOtherTool) continue;
                if (plan.InterruptedText(index, _startedJournal) is { } advice) _host.Error.WriteLine(advice);
                return machine == ExitCode.Done ? code : machine; // accepted errors count also at a change of the tool
            }

            return code;
        }
        catch (CounterException refused) when (refused.Finding is { } finding)
        {
            _host.Report(parsed, drawing.FileName, [finding]);
            if (finding.Rule == SerialRules.PlateNotFinished) await _host.Error.WriteLineAsync(Wording.Get("Series.Decide")).ConfigureAwait(false);
            if (remaining is not null) await _host.Error.WriteLineAsync(remaining).ConfigureAwait(false);
            ReportNotStarted(null, Wording.Get("Series.NotReady"));
            return ExitCode.Usage;
        }
    }

    /// <param name="remaining">What to do where it is stopped before it has started; null for the first plate.</param>
    private async Task<(int Machine, int Findings)> RunPlateOfSeriesAsync(ParseResult parsed, Drawing drawing, DrawingSettings settings, ExecutionStrategy strategy, PlateTurn turn, string? remaining, CancellationToken stop)
    {
        try
        {
            return await RunPlateAsync(parsed, drawing, settings, strategy, turn, stop).ConfigureAwait(false);
        }
        catch (OperationCanceledException) when (_startedJournal is null && remaining is not null)
        {
            await _host.Error.WriteLineAsync(remaining).ConfigureAwait(false);
            throw;
        }
    }

    /// <summary>Waits until the operator has put in the first tool of a plate, where the plate before ended with another.</summary>
    /// <returns>False: the run does not ask, or there is no input, and the series ends before this plate.</returns>
    /// <exception cref="OperationCanceledException">The operator stopped.</exception>
    private async Task<bool> HasFirstToolAsync(ParseResult parsed, PreparedJob job, Plate plate, CancellationToken stop)
    {
        if (_lastTool is not { } last || parsed.GetValue(_dryRun) || job.Sections is not [{ Tool: var first }, ..] || first.Number == last) return true;
        if (!AsksAtBreaks(parsed)) return false;
        await _host.Error.WriteLineAsync(Wording.Get(job.Settings.Machine.Axes.Z is null ? "Series.FirstToolFlat" : "Series.FirstTool", plate.Number, first.Title)).ConfigureAwait(false);
        return await _host.ReadLineAsync(stop).ConfigureAwait(false) is not null;
    }

    /// <summary>Whether the run asks at a change of the tool and at a stop, or ends there.</summary>
    private bool AsksAtBreaks(ParseResult parsed) => (parsed.GetValue(_toolChange) ?? (_host.Interactive && !parsed.GetValue(_json) ? Ask : Stop)) == Ask;

    /// <summary>Reports the errors in the letters of all plates before the first one is engraved.</summary>
    /// <returns>False if there are errors that the operator did not accept.</returns>
    private async Task<bool> LettersAreGoodAsync(ParseResult parsed, Drawing drawing, DrawingSettings settings, SeriesPlan plan, CancellationToken stop)
    {
        var errors = await plan.ReportLettersAsync(_host, parsed, drawing, settings, stop).ConfigureAwait(false);
        foreach (var error in errors) _reported.Add((error.Source, error.Message));
        return errors.Count == 0 || parsed.GetValue(_acceptErrors);
    }

    /// <exception cref="UsageException">An option that means one run only.</exception>
    private void RejectForSeveral(ParseResult parsed, SeriesPlan plan)
    {
        if (plan.Series.Fixtures.Count > 0 && _placement.Origin(parsed) is not OriginRequest.ActiveOrigin) throw new UsageException(Wording.Get("Series.FixturesOrigin"));
        if (plan.Count == 1) return;
        if (parsed.GetValue(_journal) is not null || parsed.GetValue(_trace) is not null) throw new UsageException(Wording.Get("Series.OneFile", parsed.GetValue(_journal) is null ? _trace.Name : _journal.Name));
        if (_placement.Origin(parsed) is OriginRequest.PresentPosition) throw new UsageException(Wording.Get("Series.NotHere"));
    }

    /// <param name="turn">Null for a job without plates.</param>
    /// <returns>The exit code of the run, and that of the findings of the drawing.</returns>
    private async Task<(int Machine, int Findings)> RunPlateAsync(ParseResult parsed, Drawing drawing, DrawingSettings settings, ExecutionStrategy strategy, PlateTurn? turn, CancellationToken stop)
    {
        _startedJournal = null;
        var (job, fit) = await PrepareAsync(parsed, drawing, settings, strategy, turn?.Plate, stop).ConfigureAwait(false);
        _job = job;
        var code = _host.Report(parsed, job.Drawing.FileName, [.. job.Diagnostics.Where(found => _reported.Add((found.Source, found.Message)))]);
        if (job.Diagnostics.Any(found => found.Severity == Severity.Error)) code = ExitCode.DrawingError;
        if (_followed is { } followed && !parsed.GetValue(_json)) _host.Out.WriteLine(Wording.Get("Run.Trajectories", followed.Trajectories.Count, followed.Trajectories.Sum(one => one.Curve.Points), followed.Bound));
        if (job.Motion.Program is not { } program || (code != ExitCode.Done && !parsed.GetValue(_acceptErrors)))
        {
            return (ReportNotStarted(job, NotStartedReason(job)), code);
        }

        if (job.RunRefusals is { Count: > 0 } refused)
        {
            _host.Report(parsed, job.Drawing.FileName, refused);
            return (ReportNotStarted(job, Wording.Get("Run.NotOnMachine")), ExitCode.DrawingError);
        }

        if (fit is null || program.SegmentCount == 0) return (ReportNotStarted(job, job.NoProgramReason), code);
        if (turn is not null && !await HasFirstToolAsync(parsed, job, turn.Plate, stop).ConfigureAwait(false))
        {
            _needsOtherTool = true;
            Keep(RunReport.NotStarted(settings, null, JobOutcome.ToolChange), null);
            return (ExitCode.Done, code);
        }

        return (await RunOnMachineAsync(parsed, job, fit, strategy, turn, stop).ConfigureAwait(false), code);
    }

    /// <summary>Computes everything up to the machine; a stop does not wait for it.</summary>
    /// <returns>The program with feeds limited to the link; null when there is none.</returns>
    private async Task<(PreparedJob Job, LinkFeedFit? Fit)> PrepareAsync(ParseResult parsed, Drawing drawing, DrawingSettings settings, ExecutionStrategy strategy, Plate? plate, CancellationToken stop)
    {
        var address = parsed.GetRequiredValue(_connect)!;
        return await StoppableVerb.ComputeAsync(
            () =>
            {
                var style = strategy.Style;
                var job = parsed.GetValue(_trajectory) ? Follow(TrajectoryJob.Prepare(drawing, settings, style)) : PlateJob.Prepare(drawing, settings, style, plate);
                return (job, job.Motion.Program is { } program ? JobPlan.FitToLink(program, address, strategy, job.Drawing) : null);
            },
            stop).ConfigureAwait(false);
    }

    /// <summary>Mentions that errors can be accepted only if there is something to run.</summary>
    private static string NotStartedReason(PreparedJob job)
    {
        if (DrawingFile.IsUnreadable(job.DocumentDrawing)) return Wording.Get("Run.DrawingUnreadable");
        return job.Motion.Program is null ? job.NoProgramReason : Wording.Get("Run.DrawingHasErrors");
    }

    private PreparedJob Follow(TrajectoryJob followed) => (_followed = followed).Job;

    private async Task<int> RunOnMachineAsync(ParseResult parsed, PreparedJob job, LinkFeedFit fit, ExecutionStrategy strategy, PlateTurn? turn, CancellationToken stop)
    {
        ArmingChecklist? checks = null;
        var certificate = CertificateStatus.OfRun(job, fit.Program);
        var options = new MachineRunOptions(parsed.GetRequiredValue(_connect)!, strategy)
        {
            Resume = turn is not { IsResumed: false } && parsed.GetValue(_resume) is { } interrupted ? new ResumeRequest { Journal = interrupted, LeadInMm = parsed.GetValue(_leadIn), AtOrigin = _placement.RequestsWorkOrigin(parsed) } : null,
            JournalPath = parsed.GetValue(_journal) ?? JournalFolder.NewJournal(job.Drawing.FileName, TimeProvider.System),
            TracePath = parsed.GetValue(_trace),
            DryRun = parsed.GetValue(_dryRun),
            Following = _following,
            Origin = turn?.Plate.Fixture is { } fixture ? new OriginRequest.NamedOrigin(fixture) : _placement.Origin(parsed),
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
        if (turn is not null) options = options with { Starting = token => turn.StartAsync(job.Drawing.FileName, options.JournalPath, token) };
        var quiet = _host.Quiet(parsed) || parsed.GetValue(_json);
        _host.Report(parsed, job.Drawing.FileName, fit.Diagnostics);
        var report = await SectionedRun.RunAsync(
            options,
            job.Settings.Machine.Scale,
            section => RunSectionAsync(job, fit, section with { Control = new JobControl() }, quiet, () => checks, stop),
            (ended, refused) => AskToContinueAsync(parsed, job, ended, refused, stop)).ConfigureAwait(false);
        _isAtSectionEnd = report.Result.Outcome.IsSectionEnd();
        if (report.Result.Outcome == JobOutcome.Complete && job.Sections is [.., { Tool.Number: var tool }]) _lastTool = tool;
        _startedJournal = report.Result.FrameOrigin is null ? null : report.Journal;
        if (turn is not null && await turn.EndAsync(report).ConfigureAwait(false) is { } unnoted) _host.Report(parsed, job.Drawing.FileName, [unnoted]);
        return Finish(parsed, job, report, report.Journal ?? options.JournalPath, checks);
    }

    /// <summary>Runs a job, or its strokes up to the next change of the tool or stop, and adds the run to the history.</summary>
    private async Task<MachineRunReport> RunSectionAsync(PreparedJob job, LinkFeedFit fit, MachineRunOptions options, bool quiet, Func<ArmingChecklist?> checks, CancellationToken stop)
    {
        CheckWritable(options.JournalPath);
        if (options.TracePath is { } trace) CheckWritable(trace);
        var begun = TimeProvider.System.GetUtcNow();
        using var open = _host.BeginRun(HistoryEntry.OfStarted(job, options, begun, simulated: false));
        MachineRunReport report;
        try
        {
            var lines = new LineQueue(_host.Error.WriteLine);
            await using var written = lines.ConfigureAwait(false);
            report = await ProgressBar.OfRunAsync(quiet, fit.Program, progress => MachineRun.RunAsync(job, fit.Program, options, TimeProvider.System, WithKeys(options.Control!, job.Settings.Machine.Scale, lines, progress), stop)).ConfigureAwait(false);
        }
        catch (ControllerException lost) // The link could not be established.
        {
            open.End(HistoryEntry.OfLost(job, options, lost.Message, begun));
            throw;
        }

        open.End(HistoryEntry.OfRun(job, options, report, begun, simulated: false, checks()));
        return report;
    }

    /// <summary>Waits until the operator has changed the tool and set the height of the work, or has checked the work, if the run asks for it.</summary>
    /// <param name="refused">Why the next section could not be started; null before the first attempt.</param>
    /// <returns>False: the run ends here, and is resumed later.</returns>
    /// <exception cref="OperationCanceledException">The operator stopped.</exception>
    private async Task<bool> AskToContinueAsync(ParseResult parsed, PreparedJob job, MachineRunReport ended, MachineRunReport? refused, CancellationToken stop)
    {
        if (!AsksAtBreaks(parsed)) return false;
        if ((refused?.ResumeRefusal ?? refused?.Placement?.Refusal) is { } why) _host.Report(parsed, job.Drawing.FileName, [why]);
        else if (refused is not null) await _host.Error.WriteLineAsync($"engraver: {refused.Result.Message}").ConfigureAwait(false);
        await _host.Error.WriteLineAsync(BreakText("Run.ChangeTool", "Run.ChangeToolFlat", "Run.CheckWork", job, ended)).ConfigureAwait(false);
        return await _host.ReadLineAsync(stop).ConfigureAwait(false) is not null;
    }

    /// <summary>What the operator does between two sections.</summary>
    /// <param name="tall">Text for a change of the tool on a machine with a Z axis.</param>
    /// <param name="flat">Text for one without.</param>
    /// <param name="stop">Text for a stop between repeats.</param>
    private static string BreakText(string tall, string flat, string stop, PreparedJob job, MachineRunReport ended)
    {
        var at = SectionBreak.Of(job, ended)!;
        return Wording.Get(!at.IsToolChange ? stop : job.Settings.Machine.Axes.Z is null ? flat : tall, at.Ended.Number, at.Ended.Count, at.NextText, ended.Journal ?? "");
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
        if (report.Placement?.Refusal is { } unplaced) return ReportNotPlaced(parsed, job, unplaced, checks, report.Placement.RefusedOrigin ?? job.Plate?.Fixture);
        Keep(RunReport.Json(job, report, journal, checks) with { Trajectory = RunJson.FollowedJson.From(_followed) }, job);
        if (report.StartRefusal is { } unstarted) _host.Report(parsed, job.Drawing.FileName, [unstarted]);
        if (report.StartRefusal is not null) return ExitCode.Usage;
        if (!parsed.GetValue(_json)) _host.Out.WriteLine(RunText.Sentence(job, report, SettingWording.OnConsole));
        if (report.Result.Outcome.IsSectionEnd()) _host.Error.WriteLine(BreakText("Run.Continue", "Run.ContinueFlat", "Run.ContinueRepeat", job, report));
        else if (report.Result.Outcome != JobOutcome.Complete) _host.Error.WriteLine($"engraver: {report.Result.Message}");
        if (report.TraceFailure is { } failure) _host.Error.WriteLine(Wording.Get("Run.TraceIncomplete", failure));
        foreach (var left in report.Result.NotRestored) _host.Error.WriteLine(Wording.Get("Run.NotRestored", left));
        return ExitCode.Of(report.Result.Outcome);
    }

    /// <summary>Keeps the object of <c>--json</c>, which is printed at the end.</summary>
    private void Keep(RunJson report, PreparedJob? job)
    {
        _report = job?.Plate is { } plate ? report with { Plate = PlateReportJson.From(plate) } : report;
        if (job?.Plate is { } run) _plates.Add(PlateReportJson.From(run, report));
    }

    private void Print(RunJson report)
    {
        _isPrinted = true;
        ContractJson.Write(_host.Out, _isSeries ? report with { Plates = _plates } : report, ContractJson.Default.RunJson);
    }

    /// <summary>The work origin is unknown: nothing was moved.</summary>
    /// <param name="fixture">The work origin by name that is the reason; null for the active one.</param>
    private int ReportNotPlaced(ParseResult parsed, PreparedJob job, Diagnostic refusal, ArmingChecklist? checks, string? fixture = null)
    {
        _host.Report(parsed, job.Drawing.FileName, [refusal]);
        if (fixture is not null) _host.Error.WriteLine(Wording.Get("Series.FixtureRefused", fixture));
        Keep(RunReport.NotStarted(job.Settings, job, JobOutcome.Refused, checks), job);
        return s_machineRules.Contains(refusal.Rule) ? ExitCode.DrawingError : ExitCode.Usage;
    }

    /// <param name="job">Null where none was prepared.</param>
    private int ReportNotStarted(PreparedJob? job, string why)
    {
        Keep(RunReport.NotStarted(job?.Settings ?? _settings, job, JobOutcome.Refused), job);
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
