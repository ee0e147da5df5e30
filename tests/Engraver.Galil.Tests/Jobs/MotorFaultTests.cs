using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>A motor that cannot follow (a jammed axis, a drive that gave up) while a job runs: whether the controller switches it off (OE 1) or not, the job has to see it (galil-dmc.md A.10, C.3, OE, ER).</summary>
public class MotorFaultTests
{
    [Theory]
    [InlineData(JobMode.Stream, "1")]
    [InlineData(JobMode.Calls, "1")]
    [InlineData(JobMode.Program, "1")]
    [InlineData(JobMode.Stream, "0")]
    [InlineData(JobMode.Calls, "0")]
    [InlineData(JobMode.Program, "0")]
    public async Task A_job_whose_axis_cannot_follow_ends_and_says_so_with_the_tool_off(JobMode mode, string offOnError)
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("ERA=200", "OEA=" + offOnError);
        var jam = new CancelWhen(progress => progress.X > 50000, () => bench.Controller.HoldMotor(0, true));

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Mode = mode }, jam);

        Assert.NotEqual(JobOutcome.Complete, result.Outcome);
        Assert.Contains("position error", result.Sentence, StringComparison.Ordinal);
        Assert.Equal((0, 0, false), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads, bench.Controller.Status.IsMoving));
    }
}
