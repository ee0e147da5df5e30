using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Cli.Verbs.Plates;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver plan</c>: the duration of the job on the machine, its speeds and accelerations.</summary>
internal static class PlanVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var json = JsonOption.New();
        var connect = ConnectOption.New(required: false, Wording.Get("Plan.Connect"));
        var mode = ModeOption.New();
        var rate = RateOption.New();
        var plates = new SeriesOptions();
        var sheet = new Option<bool>("--sheet") { Description = Wording.Get("Plan.Sheet") };
        var command = new Command("plan", Wording.Get("Plan.Summary"));
        drawing.AddTo(command);
        plates.AddTo(command);
        foreach (var option in (Option[])[json, connect, mode, rate, sheet]) command.Options.Add(option);
        command.SetAction(async (parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            var strategy = ModeOption.Strategy(parsed, mode, settings);
            plates.RejectSeveralTools(parsed, settings);
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            var (series, missing, reported) = await SeriesAsync(host, parsed, plates, read, settings, stop).ConfigureAwait(false);
            var job = PlateJob.Prepare(read, settings, strategy.Style, series?.Plates[0], stop);
            var rates = parsed.GetValue(rate) ?? settings.Machine.Rates;
            var (plan, planned, findings) = Planned(job, parsed.GetValue(connect), strategy, rates);
            if (series is not null) plan = plan with { Plates = await StoppableVerb.ComputeAsync(() => Planned(series, read, settings, parsed.GetValue(connect), strategy, stop), stop).ConfigureAwait(false) };
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, plan, ContractJson.Default.PlanJson);
            else if (parsed.GetValue(sheet) && planned is not null) planned.Write(host.Out);
            else PlanReport.Text(host.Out, plan);
            if (!parsed.GetValue(json)) series?.Write(host.Out);
            if (!parsed.GetValue(json) && plan.Plates is { Count: > 1 } all) await host.Out.WriteLineAsync(Wording.Get("Plan.AllPlates", all.Count, all.Sum(plate => plate.Seconds ?? 0.0))).ConfigureAwait(false);
            return Math.Max(missing, host.Report(parsed, read.FileName, [.. job.Diagnostics.Where(found => !reported.Contains(found.Message) && (missing == ExitCode.Done || series is not null || found.Rule != SerialRules.NoValue)), .. findings]));
        });
        return command;
    }

    /// <returns>Null for a drawing without fields, and where the values cannot be read: then that no field has a value needs no finding. The exit code for the
    /// findings about them, and the messages of those that the job of a plate has too.</returns>
    private static async Task<(SeriesPlan? Series, int Code, IReadOnlySet<string> Reported)> SeriesAsync(VerbHost host, ParseResult parsed, SeriesOptions options, Drawing drawing, DrawingSettings settings, CancellationToken stop)
    {
        var fields = JobPreparation.FieldsOf(drawing, settings);
        if (!fields.Any && options.Requested(parsed) is null) return (null, ExitCode.Done, new HashSet<string>());
        try
        {
            var (series, findings) = await SeriesPlan.ReadAsync(parsed, options, drawing, fields, isDryRun: true, null, stop).ConfigureAwait(false);
            var code = host.Report(parsed, options.CsvFile(parsed) ?? drawing.FileName, findings);
            if (series is null) return (null, code, new HashSet<string>());
            code = Math.Max(code, host.Report(parsed, drawing.FileName, series.Findings));
            var letters = await series.ReportLettersAsync(host, parsed, drawing, settings, stop).ConfigureAwait(false);
            return (series, letters.Count > 0 ? Math.Max(code, ExitCode.DrawingError) : code, series.Findings.Concat(letters).Select(finding => finding.Message).ToHashSet());
        }
        catch (CounterException refused) when (refused.Finding is { } finding)
        {
            return (null, host.Report(parsed, drawing.FileName, [finding]), new HashSet<string>());
        }
    }

    /// <summary>Every plate with its time on the machine.</summary>
    private static IReadOnlyList<PlateReportJson> Planned(SeriesPlan series, Drawing drawing, DrawingSettings settings, ControllerAddress? address, ExecutionStrategy strategy, CancellationToken stop)
    {
        var plates = new List<PlateReportJson>();
        foreach (var plate in series.Plates)
        {
            var program = PlateJob.Prepare(drawing, settings, strategy.Style, plate, stop).Motion.Program;
            plates.Add(PlateReportJson.From(plate) with { Seconds = program is null ? null : JobPlan.PlannedTimes(JobPlan.FitToLink(program, address, strategy, drawing).Program, address, strategy).Total });
        }

        return plates;
    }

    private static (PlanJson Plan, JobSheet? Sheet, IReadOnlyList<Diagnostic> Findings) Planned(PreparedJob job, ControllerAddress? address, ExecutionStrategy strategy, JobRates? rates)
    {
        if (job.Motion.Program is not { } program) return (PlanReport.Json(job, null, null, _ => default), null, []);
        var fit = JobPlan.FitToLink(program, address, strategy, job.Drawing);
        var sheet = JobSheet.Of(job, fit.Program, JobPlan.StrokeTimes(fit.Program, address, strategy), rates);
        return (PlanReport.Json(job, fit.Program, sheet, part => JobPlan.PlannedTimes(part, address, strategy)), sheet, fit.Diagnostics);
    }
}
