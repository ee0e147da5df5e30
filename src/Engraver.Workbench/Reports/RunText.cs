using Engraver.Core.EntityTables;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Reports;

/// <summary>Text report of a run.</summary>
public static class RunText
{
    /// <summary>Minimum displayed length, millimetres; a shorter one would be shown as 0.</summary>
    private const double MinShown = 0.001;

    /// <summary>A smaller lag is not stated, seconds and part of the planned time.</summary>
    private const double MinLag = 0.1;
    private const double MinLagShare = 0.01;

    /// <param name="spell">Names settings for the front end (<see cref="SettingWording"/>).</param>
    public static string Sentence(PreparedJob job, MachineRunReport report, Func<string, string> spell)
    {
        ArgumentNullException.ThrowIfNull(spell);
        var result = report.Result;
        var planned = job.Motion.Program?.SegmentCount ?? 0;
        var findings = report.IsDryRun ? [Wording.Get("RunText.DryRun")] : Findings(report, RefusedCount(job), job.NotCut);
        if (job.NotCut.Counts.Count > 0) findings = [.. findings, $"{job.NotCut.Clause}: {job.NotCut.HowTo}"];
        return Wording.Get(report.IsDryRun ? "RunText.SegmentsTraversed" : "RunText.SegmentsCut", OutcomeText.DisplayText(result.Outcome), result.SegmentsExecuted, planned, result.Seconds, spell(string.Join("; ", findings)));
    }

    /// <summary>Number of entities of the drawing and its blocks that could not be converted to curves.</summary>
    public static int RefusedCount(PreparedJob job) => job.Drawing.Balance.Refused.Count + job.Drawing.Balance.RefusedInBlocks.Count;

    /// <summary>Where the machine was slower than planned; null where it lost little.</summary>
    private static string? LagClause(MachineRunReport report) => report.Lag is { Places: [var most, ..] } lag && lag.Seconds >= Math.Max(MinLag, MinLagShare * report.PlannedSeconds)
        ? Wording.Get("RunText.Lag", lag.Seconds, most.Place.X, most.Place.Y, most.Seconds, most.Speed, most.PlannedSpeed)
        : null;

    /// <summary>The deviation, the cut part of the drawing, and restrictions of both.</summary>
    private static List<string> Findings(MachineRunReport report, int leftOut, NotCutFindings notCut)
    {
        var (judgement, openLoop) = (report.Judgement, report.CommandedOnly);
        if (judgement.MaxDeviationMm is not { } deviation) return [Wording.Get("RunText.CutUnknown")];
        var isOpenLoop = openLoop.Count > 0;
        List<string> findings = [Wording.Get(judgement.Source == "record" ? "RunText.DeviationOfSimulatedMotors" : judgement.FollowingMm is not null && !isOpenLoop ? "RunText.DeviationOfMotors" : isOpenLoop ? "RunText.DeviationOfCommandedPositions" : "RunText.DeviationOfPolledPositions", deviation)];
        if (judgement.CornerDeviationMm is { } corner && corner > deviation) findings.Add(Wording.Get("RunText.CornerDeviation", corner));
        if ((report.ToleranceMm, judgement.FollowingMm) is ({ } tolerance, { } following and > 0.0)) findings.Add(Wording.Get("RunText.ToleranceWithFollowingError", tolerance, following));
        findings.Add(judgement.MissingLengthMm switch
        {
            null => Wording.Get("RunText.LengthNotCutUnknown"),
            >= MinShown and var length => Wording.Get("RunText.LengthNotCut", length),
            > 0.0 => Wording.Get("RunText.LengthNotCutBelow", MinShown),
            _ when report is { Section: { IsLast: false } section } => Wording.Get("RunText.SectionsCut", section.Number, section.Count),
            _ when leftOut > 0 => Wording.Get("RunText.AllThatWasReadCut"),
            _ => Wording.Get(notCut.Counts.Count > 0 ? "RunText.AllCurvesCut" : "RunText.WholeDrawingCut"),
        });
        if (LagClause(report) is { } lag) findings.Add(lag);
        if (leftOut > 0) findings.Add(Wording.Count("RunText.EntitiesLeftOut", leftOut));
        if (isOpenLoop) findings.Add(Wording.Get("RunText.OpenLoop", string.Join(", ", openLoop)));
        return findings;
    }
}
