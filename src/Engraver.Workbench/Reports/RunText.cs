using Engraver.Core.EntityTables;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Reports;

/// <summary>Reports of a run for people.</summary>
public static class RunText
{
    /// <summary>A shorter length would be shown as none, millimetres.</summary>
    private const double LeastShown = 0.001;

    /// <param name="spell">Names settings as they are given here (<see cref="SettingWording"/>).</param>
    public static string Sentence(PreparedJob job, MachineRunReport report, Func<string, string> spell)
    {
        ArgumentNullException.ThrowIfNull(spell);
        var result = report.Result;
        var planned = job.Motion.Program?.SegmentCount ?? 0;
        return Wording.Get(report.IsDryRun ? "RunText.SegmentsGone" : "RunText.SegmentsCutMachineTime", OutcomeText.Said(result.Outcome), result.SegmentsExecuted, planned, result.Seconds, spell(report.IsDryRun ? Wording.Get("RunText.DryRun", Unseen(job.NotCut)) : Verdict(report, LeftOut(job), job.NotCut)));
    }

    /// <summary>Entities of the drawing, in its blocks too, that gave no curve though they should have.</summary>
    public static int LeftOut(PreparedJob job) => job.Drawing.Balance.Refused.Count + job.Drawing.Balance.RefusedInBlocks.Count;

    /// <summary>What is seen and not cut, and how to have it cut; empty when there is nothing of the kind.</summary>
    private static string Unseen(NotCutFindings notCut) => notCut.Counts.Count == 0 ? "" : $"; {notCut.Clause}: {notCut.HowTo}";

    /// <summary>Of servos that were behind their command: by how much, and what was allowed.</summary>
    private static string Tolerance(MachineRunReport report) => (report.ToleranceMm, report.Judgement.FollowingMm) switch
    {
        ({ } tolerance, { } following and > 0.0) => Wording.Get("RunText.ToleranceWithLag", tolerance, following),
        _ => "",
    };

    private static string Verdict(MachineRunReport report, int leftOut, NotCutFindings notCut)
    {
        var (judgement, openLoop) = (report.Judgement, report.Unseen);
        var unseen = Unseen(notCut);
        if (judgement.MaxDeviationMm is not { } deviation) return Wording.Get("RunText.NothingKnownAboutCut", unseen);
        var isOpenLoop = openLoop.Count > 0;
        var who = Wording.Get(judgement.Source == "record" ? "RunText.SimulatedMotors" : judgement.FollowingMm is not null && !isOpenLoop ? "RunText.Motors" : isOpenLoop ? "RunText.CommandedPositions" : "RunText.PolledPositions");
        var missing = judgement.MissingLengthMm switch
        {
            null => Wording.Get("RunText.HowMuchMissingNot"),
            >= LeastShown and var length => Wording.Get("RunText.MmDrawingMissing", length),
            > 0.0 => Wording.Get("RunText.LittleDrawingMissing", LeastShown),
            _ when leftOut > 0 => Wording.Get("RunText.NothingWhatCouldRead"),
            _ => unseen.Length > 0 ? Wording.Get("RunText.NothingItsCurvesMissing") : Wording.Get("RunText.NothingMissing"),
        };
        if (leftOut > 0) missing += Wording.Get("RunText.ButItsEntitiesCould", leftOut, leftOut == 1 ? Wording.Get("RunText.Is") : Wording.Get("RunText.Are"));
        if (isOpenLoop) missing = Wording.Get("RunText.IfTheSteppersFollowed", missing, string.Join(", ", openLoop));
        return Wording.Get("RunText.WorstMmFromDrawing", who, deviation, missing, unseen, Tolerance(report));
    }
}
