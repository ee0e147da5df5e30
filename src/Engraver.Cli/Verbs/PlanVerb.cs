using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;

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
        var sheet = new Option<bool>("--sheet") { Description = Wording.Get("Plan.Sheet") };
        var command = new Command("plan", Wording.Get("Plan.Summary"));
        drawing.AddTo(command);
        foreach (var option in (Option[])[json, connect, mode, rate, sheet]) command.Options.Add(option);
        command.SetAction((parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            var strategy = ModeOption.Strategy(parsed, mode, settings);
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            var job = JobPreparation.Prepare(read, settings, strategy.Style);
            var rates = parsed.GetValue(rate) ?? settings.Machine.Rates;
            var (plan, times, findings) = Planned(job, parsed.GetValue(connect), strategy, rates);
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, plan, ContractJson.Default.PlanJson);
            else if (parsed.GetValue(sheet) && times is { } known) JobSheet.Of(job, known, rates).Write(host.Out);
            else PlanReport.Text(host.Out, plan);
            return Task.FromResult(host.Report(parsed, read.FileName, [.. job.Diagnostics, .. findings]));
        });
        return command;
    }

    private static (PlanJson Plan, MotionTimes? Times, IReadOnlyList<Diagnostic> Findings) Planned(PreparedJob job, ControllerAddress? address, ExecutionStrategy strategy, JobRates? rates)
    {
        if (job.Motion.Program is not { } program) return (PlanReport.Json(job, null, default, null), null, []);
        var fit = JobPlan.FitToLink(program, address, strategy, job.Drawing);
        var times = JobPlan.PlannedTimes(fit.Program, address, strategy);
        return (PlanReport.Json(job, fit.Program, times, rates), times, fit.Diagnostics);
    }
}
