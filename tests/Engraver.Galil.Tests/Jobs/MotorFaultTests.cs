using Engraver.Core.Machines;
using Engraver.Galil.Jobs;

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

    /// <summary>The factory's ER is 16384 counts: of an axis that stands 8 mm beside its place the controller says nothing by itself.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_job_at_whose_end_a_motor_stands_beside_its_place_by_less_than_ER_is_not_called_complete(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var jam = new CancelWhen(progress => progress.X > 50000, () => bench.Controller.HoldMotor(0, true));

        var result = await bench.RunAsync(MotionPrograms.LongLine(60000), SimulatedBench.Job with { Mode = mode }, jam);

        Assert.Equal(JobOutcome.Deviated, result.Outcome);
        Assert.Contains("could not follow", result.Sentence, StringComparison.Ordinal);
        Assert.Contains("X is ", result.Sentence, StringComparison.Ordinal);
        Assert.NotEqual("", result.PositionDoubt);
        Assert.Equal(0, (int)bench.Controller.Status.Outputs);
    }

    [Fact]
    public async Task A_move_by_hand_whose_motor_did_not_come_along_is_not_called_done()
    {
        await using var bench = new SimulatedBench();
        bench.Controller.HoldMotor(1, true);
        await using var session = await bench.OpenAsync();

        var result = await JobRunner.GoToAsync(MotionPrograms.LongLine(1000), new CountsPoint(3000, 9000), session, SimulatedBench.Job, null, CancellationToken.None);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("Y is 9000", result.Sentence, StringComparison.Ordinal);
        Assert.NotEqual("", result.PositionDoubt);
    }

    /// <summary>A servo that trails its command by a time constant comes to its place behind the end of the motion, and is waited for.</summary>
    [Fact]
    public async Task A_motor_that_settles_late_is_waited_for()
    {
        await using var bench = new SimulatedBench(lag: TimeSpan.FromMilliseconds(60));
        await using var session = await bench.OpenAsync();

        var result = await JobRunner.GoToAsync(MotionPrograms.LongLine(1000), new CountsPoint(30000, 9000), session, SimulatedBench.Job, null, CancellationToken.None);

        Assert.True(result.Outcome == JobOutcome.Complete, result.Sentence);
    }
}
