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
    public static RunJson Json(PreparedJob job, MachineRunReport report, string journal, ArmingChecklist? checks) => new()
    {
        Outcome = OutcomeText.Token(report.Result.Outcome),
        SegmentsSent = report.Result.SegmentsSent,
        SegmentsExecuted = report.Result.SegmentsExecuted,
        Seconds = report.Result.Seconds,
        PlannedSeconds = report.PlannedSeconds,
        Underruns = report.Result.Underruns,
        Rejected = report.Result.Rejected,
        FinalX = report.Result.FinalPosition?.X,
        FinalY = report.Result.FinalPosition?.Y,
        CountsPerMillimetre = Scale(job.Settings),
        MaxDeviation = report.Judgement.MaxDeviationMm,
        CornerDeviation = report.Judgement.CornerDeviationMm,
        MissingLength = report.Judgement.MissingLengthMm,
        Lag = RunJson.LagJson.From(report.Lag),
        DeviationSource = report.Judgement.Source,
        Journal = journal,
        LeftOut = LeftOut(job),
        NotCut = job.NotCut.Counts,
        Origin = Origin(job.Settings, report.Placement),
        FinalZ = job.Settings.Machine.Axes.Z is null ? null : report.Result.FinalPosition?.Z,
        Holds = report.Result.Holds,
        ResumedFrom = report.ResumedFrom is { } from ? new RunJson.ResumedJson(from.Segments, job.Settings.Machine.Scale.Finer.LengthOf(from.Along)) : null,
        Checks = StartCheckJson.Of(checks),
        OpenLoop = [.. report.OpenLoop.Select(axis => axis.ToString())],
        MaxFollowingError = report.Judgement.FollowingMm,
        Tolerance = report.ToleranceMm,
        Fonts = job.Fonts,
        Operations = OperationJson.Of(job, report.Judgement.Operations),
        Sections = SectionJson.Of(report),
    };

    /// <summary>A run that did not reach the machine: nothing was sent.</summary>
    /// <param name="checks">The start checks, as far as they were run.</param>
    /// <param name="job">Null when it was stopped before it was prepared.</param>
    public static RunJson NotStarted(DrawingSettings settings, PreparedJob? job, JobOutcome outcome, ArmingChecklist? checks = null) => new()
    {
        Outcome = OutcomeText.Token(outcome),
        SegmentsSent = 0,
        SegmentsExecuted = 0,
        Seconds = 0.0,
        PlannedSeconds = null,
        Underruns = 0,
        Rejected = 0,
        FinalX = null,
        FinalY = null,
        CountsPerMillimetre = Scale(settings),
        MaxDeviation = null,
        MissingLength = null,
        DeviationSource = "none",
        Journal = null,
        LeftOut = job is null ? null : LeftOut(job),
        NotCut = job?.NotCut.Counts,
        Fonts = job?.Fonts ?? [],
        Operations = OperationJson.Of(job, []),
        Origin = null,
        FinalZ = null,
        Holds = 0,
        ResumedFrom = null,
        Checks = StartCheckJson.Of(checks),
    };

    private static RunJson.OriginJson? Origin(DrawingSettings settings, PlacementResult? placement) => placement is { Frame: { } frame }
        ? new(settings.Machine.Scale.X.ToMillimetres(frame.X), settings.Machine.Scale.Y.ToMillimetres(frame.Y), placement.Source switch { OriginSource.Here => "here", OriginSource.Given => "given", _ => "work" })
        : null;

    /// <summary>The length of an entity that cannot be read is unknown.</summary>
    private static RunJson.LeftOutJson LeftOut(PreparedJob job) => RunText.RefusedCount(job) is var count and > 0 ? new(count, null) : new(0, 0.0);

    private static RunJson.ScaleJson Scale(DrawingSettings settings) => new(settings.Machine.Scale.X.CountsPerMillimetre, settings.Machine.Scale.Y.CountsPerMillimetre);
}
