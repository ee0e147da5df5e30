using Engraver.Simulator;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>Judges a job by the record of a simulated controller.</summary>
internal static class RecordJudgement
{
    /// <param name="frameX">Counts of the controller at the drawing's zero.</param>
    public static RunJudgement Of(PreparedJob job, IReadOnlyList<MotionSample> record, long frameX, long frameY, long frameZ = 0)
    {
        var listener = new RecordListener(job.Settings.Machine, RunJudge.JudgeOf(job)) { Motors = RunJudge.MotorsOf(job) };
        listener.Start(frameX, frameY, frameZ);
        foreach (var sample in record) listener.Add(sample);
        return RunJudge.ByRecord(listener.Verdicts()[0], listener.Motors);
    }
}
