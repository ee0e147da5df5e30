using Engraver.Galil.Jobs;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>A motor that cannot follow (a jammed axis, a drive that gave up) while a job runs: the controller switches it off by OE, and the job has to see it (galil-dmc.md A.10, OE, ER).</summary>
public class MotorFaultTests
{
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_job_whose_motor_went_off_says_so_with_the_tool_off(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("ERA=200", "OEA=1");
        var jam = new CancelWhen(progress => progress.X > 50000, () => bench.Controller.HoldMotor(0, true));

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Mode = mode }, jam);

        Assert.NotEqual(JobOutcome.Complete, result.Outcome);
        Assert.Contains("position error", result.Sentence, StringComparison.Ordinal);
        Assert.Equal((0, 0, false), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads, bench.Controller.Status.IsMoving));
    }
}
