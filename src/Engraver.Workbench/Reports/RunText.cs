using Engraver.Core.EntityTables;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Reports;

/// <summary>How a run is told to people.</summary>
public static class RunText
{
    public static string Sentence(PreparedJob job, MachineRunReport report)
    {
        var result = report.Result;
        var planned = job.Motion.Program?.SegmentCount ?? 0;
        return Wording.Get("RunText.SegmentsCutMachineTime", OutcomeText.Word(result.Outcome), result.SegmentsExecuted, planned, result.Seconds, Verdict(report.Judgement, LeftOut(job), job.NotCut));
    }

    /// <summary>Entities of the drawing, in its blocks too, that gave no curve though they should have.</summary>
    public static int LeftOut(PreparedJob job) => job.Drawing.Balance.Refused.Count + job.Drawing.Balance.RefusedInBlocks.Count;

    private static string Verdict(RunJudgement judgement, int leftOut, NotCutFindings notCut)
    {
        var unseen = notCut.Counts.Count == 0 ? "" : $"; {notCut.Clause}";
        if (judgement.MaxDeviationMm is not { } deviation) return Wording.Get("RunText.NothingKnownAboutCut", unseen);
        var who = judgement.Source == "record" ? Wording.Get("RunText.SimulatedMotors") : Wording.Get("RunText.PolledPositions");
        var missing = judgement.MissingLengthMm switch
        {
            null => Wording.Get("RunText.HowMuchMissingNot"),
            > 0.0 and var length => Wording.Get("RunText.MmDrawingMissing", length),
            _ when leftOut > 0 => Wording.Get("RunText.NothingWhatCouldRead"),
            _ => unseen.Length > 0 ? Wording.Get("RunText.NothingItsCurvesMissing") : Wording.Get("RunText.NothingMissing"),
        };
        if (leftOut > 0) missing += Wording.Get("RunText.ButItsEntitiesCould", leftOut, leftOut == 1 ? Wording.Get("RunText.Is") : Wording.Get("RunText.Are"));
        return Wording.Get("RunText.WorstMmFromDrawing", who, deviation, missing, unseen);
    }
}
