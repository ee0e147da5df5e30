using Engraver.Core.Machines;
using Engraver.Simulator;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Tests.Machines.Runs;

/// <summary>Judging motors by the record: a run whose motors exceed the allowed following error is not correct, whatever was commanded.</summary>
public sealed class MotorJudgeTests
{
    private static readonly MachineProfile s_profile = MachineProfile.Default;

    [Theory]
    [InlineData(0.0, 0.0, JobOutcome.Complete)]
    [InlineData(0.2, 0.2, JobOutcome.Complete)]
    [InlineData(1.8, 1.8, JobOutcome.Complete)]
    [InlineData(2.8, 2.8, JobOutcome.Deviated)]
    public void A_motor_that_is_behind_beside_the_drawing_is_judged_by_the_lag_that_the_profile_allows(double behind, double deviation, JobOutcome outcome)
    {
        var job = MachineBench.Job();
        var judgement = Judged(job, behind);

        Assert.Equal(deviation, judgement.MaxDeviationMm!.Value, 3);
        Assert.Equal(0.0, judgement.CommandedDeviationMm!.Value, 6);
        Assert.Equal(behind, judgement.FollowingMm!.Value, 3);
        var judged = RunVerdict.Judge(job, job.Motion.Program!, JobResult.NotStarted(1, "Done.") with { Outcome = JobOutcome.Complete }, judgement with { MissingLengthMm = 0.0 });
        Assert.Equal(outcome, judged.Outcome);
        if (outcome == JobOutcome.Deviated) Assert.Matches(@"^Maximum deviation of the motors from the drawing 2\.8 mm, allowed [0-9.]+ mm\. Position: 10,", judged.Message);
        Assert.Equal(1.9035, RunVerdict.Tolerance(job, job.Motion.Program!, judgement), 4);
    }

    /// <summary>A motor that was blocked along a line and is released cuts off the corner that was commanded in between.</summary>
    [Fact]
    public void The_way_of_a_motor_that_is_free_again_is_judged_between_the_samples_too()
    {
        var job = MachineBench.Job();
        var listener = Listener(job);
        listener.Add(At(1, 0, 0, 1));
        listener.Add(At(2, 20_000, 0, 1) with { A = 0, Error = (20_000, 0, 0, 0) });
        listener.Add(At(3, 35_000, 0, 1) with { A = 0, Error = (35_000, 0, 0, 0) });
        listener.Add(At(4, 35_000, 0, 1));

        Assert.Equal(7.5, RunJudge.ByRecord(listener.Verdicts()[0], listener.Motors).MaxDeviationMm!.Value, 1); // half-way from the line's end at 20 to the circle's left side at 35
    }

    private static RunJudgement Judged(Engraver.Workbench.Documents.PreparedJob job, double behind)
    {
        var (listener, error) = (Listener(job), (int)(behind * 1000.0));
        for (var i = 0; i <= 10; i++) listener.Add(At(i, 1000 * i, 0, 1));
        listener.Add(At(11, 10_000, 0, 1) with { B = -error, Error = (0, error, 0, 0) });
        listener.Add(At(12, 10_500, 0, 1));
        return RunJudge.ByRecord(listener.Verdicts()[0], listener.Motors);
    }

    private static RecordListener Listener(Engraver.Workbench.Documents.PreparedJob job)
    {
        var listener = new RecordListener(s_profile, RunJudge.JudgeOf(job)) { Motors = RunJudge.MotorsOf(job) };
        listener.Start(0.0, 0.0);
        return listener;
    }

    private static MotionSample At(long sample, int x, int y, byte outputs) => new(sample, x, y, 0, 0, outputs);
}
