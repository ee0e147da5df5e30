using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines.Runs;

/// <summary>A run with a deviation beyond its tolerance is not complete.</summary>
public class RunVerdictTests
{
    private static readonly PreparedJob s_job = JobPreparation.Prepare(
        DrawingFile.Open(Path.Combine(RepositoryFolder.Samples, "paper-001.dxf"), new DrawingSettings(), CancellationToken.None), new DrawingSettings(), MotionStyle.Continuous);

    [Theory]
    [InlineData(0.0035, 0.0, "record", "complete")]
    [InlineData(0.0036, 0.0, "record", "deviated")]
    [InlineData(0.001, 0.01, "record", "deviated")]
    [InlineData(0.0135, 0.04, "polled", "complete")] // two numbers of a poll may be a sample apart: 20 counts of way
    [InlineData(0.0136, 0.0, "polled", "deviated")]
    [InlineData(0.001, 0.06, "polled", "deviated")]
    [InlineData(null, null, "none", "complete")]
    public void What_the_run_measured_decides(double? deviation, double? missing, string source, string outcome) =>
        Assert.Equal(outcome, OutcomeText.Token(Judged(new RunJudgement(deviation, missing, source), JobOutcome.Complete).Outcome));

    [Fact]
    public void Place_and_size_are_said()
    {
        Assert.StartsWith(
            "Maximum deviation of the run from the drawing 396.001 mm, allowed 0.0135 mm. Position: -44,0.5. The values come from the controller.",
            Judged(new RunJudgement(396.001, 12.0, "polled") { DeviationAt = new Point2D(-44, 0.5) }, JobOutcome.Complete).Message, StringComparison.Ordinal);
        Assert.StartsWith(
            "7.9 mm of the drawing were not cut. Position: 1,2. The values come", Judged(new RunJudgement(0.001, 7.9, "record") { MissingAt = new Point2D(1, 2) }, JobOutcome.Complete).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_run_that_was_stopped_stays_stopped() => Assert.Equal(JobOutcome.Stopped, Judged(new RunJudgement(5.0, 100.0, "record"), JobOutcome.Stopped).Outcome);

    private static JobResult Judged(RunJudgement judgement, JobOutcome outcome) => RunVerdict.Judge(
        s_job,
        s_job.Motion.Program!,
        JobResult.NotStarted(0, "Done.") with { Outcome = outcome, SegmentsSent = 4, SegmentsExecuted = 4, Seconds = 1.0, ExecutedByStroke = [4], LengthByStroke = [1.0] },
        judgement);
}
