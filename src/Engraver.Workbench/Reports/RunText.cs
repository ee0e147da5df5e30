using System.Globalization;
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
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{OutcomeText.Word(result.Outcome)}: {result.SegmentsExecuted} of {planned} segments cut in {result.Seconds:0.0} s of machine time; {Verdict(report.Judgement, LeftOut(job), job.NotCut)}.");
    }

    /// <summary>Entities of the drawing, in its blocks too, that gave no curve though they should have.</summary>
    public static int LeftOut(PreparedJob job) => job.Drawing.Balance.Refused.Count + job.Drawing.Balance.RefusedInBlocks.Count;

    private static string Verdict(RunJudgement judgement, int leftOut, NotCutFindings notCut)
    {
        var unseen = notCut.Counts.Count == 0 ? "" : $"; {notCut.Clause}";
        if (judgement.MaxDeviationMm is not { } deviation) return "nothing is known about the cut" + unseen;
        var who = judgement.Source == "record" ? "the simulated motors were" : "the polled positions were";
        var missing = judgement.MissingLengthMm switch
        {
            null => "how much of it is missing is not known",
            > 0.0 and var length => string.Create(CultureInfo.InvariantCulture, $"{length:0.###} mm of the drawing are MISSING"),
            _ when leftOut > 0 => "nothing of what could be read is missing",
            _ => unseen.Length > 0 ? "nothing of its curves is missing" : "nothing of it is missing",
        };
        if (leftOut > 0) missing += string.Create(CultureInfo.InvariantCulture, $", but {leftOut} of its entities could not be read and {(leftOut == 1 ? "is" : "are")} LEFT OUT");
        return string.Create(CultureInfo.InvariantCulture, $"{who} at worst {deviation:0.0000} mm from the drawing and {missing}{unseen}");
    }
}
