using System.Globalization;
using Engraver.Galil.Jobs;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;

namespace Engraver.Cli.Output;

/// <summary>How a run is told: one sentence for people, one object for programs.</summary>
internal static class RunReport
{
    public static RunJson Json(PreparedJob job, MachineRunReport report, string journal) => new(
        Word(report.Result.Outcome),
        report.Result.SegmentsSent,
        report.Result.SegmentsExecuted,
        report.Result.Seconds,
        report.PlannedSeconds,
        report.Result.Underruns,
        report.Result.Rejected,
        report.Result.FinalPosition?.X,
        report.Result.FinalPosition?.Y,
        Scale(job),
        report.Judgement.MaxDeviationMm,
        report.Judgement.MissingLengthMm,
        report.Judgement.Source,
        journal);

    /// <summary>A run that never reached the machine: nothing sent, nothing known.</summary>
    public static RunJson NotStarted(PreparedJob job) =>
        new("refused", 0, 0, 0.0, null, 0, 0, null, null, Scale(job), null, null, "none", null);

    public static string Sentence(PreparedJob job, MachineRunReport report)
    {
        var result = report.Result;
        var planned = job.Motion.Program?.SegmentCount ?? 0;
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{Word(result.Outcome)}: {result.SegmentsExecuted} of {planned} segments cut in {result.Seconds:0.0} s of machine time; {Verdict(report.Judgement)}.");
    }

    private static string Verdict(RunJudgement judgement)
    {
        if (judgement.MaxDeviationMm is not { } deviation) return "nothing is known about the cut";
        var who = judgement.Source == "record" ? "the simulated motors were" : "the polled positions were";
        var missing = judgement.MissingLengthMm is > 0.0 and var length
            ? string.Create(CultureInfo.InvariantCulture, $"{length:0.###} mm of the drawing are MISSING")
            : "nothing of it is missing";
        return string.Create(CultureInfo.InvariantCulture, $"{who} at worst {deviation:0.0000} mm from the drawing and {missing}");
    }

    private static RunJson.ScaleJson Scale(PreparedJob job) => new(job.Settings.Machine.CountsPerMillimetreX, job.Settings.Machine.CountsPerMillimetreY);

    private static string Word(JobOutcome outcome) => outcome switch
    {
        JobOutcome.Complete => "complete",
        JobOutcome.Stopped => "stopped",
        JobOutcome.Refused => "refused",
        _ => "linkLost",
    };
}
