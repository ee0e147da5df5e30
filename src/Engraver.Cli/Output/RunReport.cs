using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Output;

/// <summary>Reports a run as one JSON object.</summary>
internal static class RunReport
{
    public static RunJson Json(PreparedJob job, MachineRunReport report, string journal, ArmingChecklist? checks) => new(
        OutcomeText.Word(report.Result.Outcome),
        report.Result.SegmentsSent,
        report.Result.SegmentsExecuted,
        report.Result.Seconds,
        report.PlannedSeconds,
        report.Result.Underruns,
        report.Result.Rejected,
        report.Result.FinalPosition?.X,
        report.Result.FinalPosition?.Y,
        Scale(job.Settings),
        report.Judgement.MaxDeviationMm,
        report.Judgement.MissingLengthMm,
        report.Judgement.Source,
        journal,
        LeftOut(job),
        job.NotCut.Counts,
        Origin(job.Settings, report.Placement),
        job.Settings.Machine.Axes.Z is null ? null : report.Result.FinalPosition?.Z,
        report.Result.Holds,
        report.ResumedFrom is { } from ? new RunJson.ResumedJson(from.Segments, job.Settings.Machine.Scale.Finer.LengthOf(from.Along)) : null,
        StartCheckJson.Of(checks)) { OpenLoop = [.. report.OpenLoop.Select(axis => axis.ToString())], MaxFollowingError = report.Judgement.FollowingMm, Tolerance = report.ToleranceMm };

    /// <summary>A run that never reached the machine: nothing sent, nothing known.</summary>
    /// <param name="checks">The list before the start, as far as it was gone through.</param>
    /// <param name="job">Null when it was stopped before it was prepared.</param>
    public static RunJson NotStarted(DrawingSettings settings, PreparedJob? job, JobOutcome outcome, ArmingChecklist? checks = null) =>
        new(OutcomeText.Word(outcome), 0, 0, 0.0, null, 0, 0, null, null, Scale(settings), null, null, "none", null, job is null ? null : LeftOut(job), job?.NotCut.Counts, null, null, 0, null, StartCheckJson.Of(checks));

    private static RunJson.OriginJson? Origin(DrawingSettings settings, PlacementResult? placement) => placement is { Frame: { } frame }
        ? new(settings.Machine.Scale.X.ToMillimetres(frame.X), settings.Machine.Scale.Y.ToMillimetres(frame.Y), placement.Source switch { OriginSource.Here => "here", OriginSource.Given => "given", _ => "work" })
        : null;

    /// <summary>An entity that cannot be read has no length that anybody knows.</summary>
    private static RunJson.LeftOutJson LeftOut(PreparedJob job) => RunText.LeftOut(job) is var count and > 0 ? new(count, null) : new(0, 0.0);

    private static RunJson.ScaleJson Scale(DrawingSettings settings) => new(settings.Machine.Scale.X.CountsPerMillimetre, settings.Machine.Scale.Y.CountsPerMillimetre);
}
