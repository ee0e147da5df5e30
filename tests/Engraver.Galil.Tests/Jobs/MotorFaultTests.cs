using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>A motor that cannot follow (a jammed axis, a failed drive) while a job runs: whether the controller switches it off (OE 1) or not, the job must
/// detect it (galil-dmc.md A.10, C.3, OE, ER).</summary>
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

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Strategy = mode.Strategy() }, jam);

        Assert.NotEqual(JobOutcome.Complete, result.Outcome);
        Assert.Contains("following error", result.Message, StringComparison.Ordinal);
        Assert.Equal((0, 0, false), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads, bench.Controller.Status.IsMoving));
    }

    /// <summary>The job's ER is 4 mm at the default profile: the controller does not report an axis that is 2 mm beside its position.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_job_at_whose_end_a_motor_stands_beside_its_place_by_less_than_ER_is_not_called_complete(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var jam = new CancelWhen(progress => progress.X > 58000, () => bench.Controller.HoldMotor(0, true));

        var result = await bench.RunAsync(MotionPrograms.LongLine(60000), SimulatedBench.Job with { Strategy = mode.Strategy() }, jam);

        Assert.Equal(JobOutcome.Deviated, result.Outcome);
        Assert.Contains("could not follow", result.Message, StringComparison.Ordinal);
        Assert.Contains("following error in counts: X ", result.Message, StringComparison.Ordinal);
        Assert.NotEqual("", result.PositionDoubt);
        Assert.Equal(0, (int)bench.Controller.Status.Outputs);
    }

    /// <summary>0.5 mm and the path of 0.07 s at the highest speed, 50 mm/s: 4 mm. The factory limit would be 16 mm; OE is not changed.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task The_controller_itself_ends_a_job_beyond_the_following_error_of_the_profile_and_gets_its_limit_back(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("ERA=12345", "OEB=1");
        var jam = new CancelWhen(progress => progress.X > 50000, () => bench.Controller.HoldMotor(0, true));

        var result = await bench.RunAsync(MotionPrograms.LongLine(60000), SimulatedBench.Job with { Strategy = mode.Strategy() }, jam);

        Assert.NotEqual(JobOutcome.Complete, result.Outcome);
        Assert.Contains("following error", result.Message, StringComparison.Ordinal);
        Assert.InRange(result.FinalPosition!.Value.X, 53_500, 56_000);
        Assert.Empty(result.NotRestored);
        Assert.Equal(("12345", "1"), ((await bench.WholeAsync("_ERA")).Trim(), (await bench.WholeAsync("_OEB")).Trim()));
        Assert.Equal(0, (int)bench.Controller.Status.Outputs);
    }

    [Fact]
    public async Task A_limit_of_the_profile_is_sent_in_counts_of_each_axis_and_none_to_a_stepper()
    {
        var profile = MachineProfile.Default with { FollowingErrorMm = 1.25, Axes = new MachineAxes(new MachineAxis('A', 1000.0), new MachineAxis('B', -40.0), new MachineAxis('C', 100.0, 2.0)) };
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();

        Assert.Equal(["ERA=1250", "ERB=50"], PositionErrorLimit.Commands(profile, session.Found));
        Assert.Equal(["ERA=4000", "ERB=4000"], PositionErrorLimit.Commands(MachineProfile.Default, session.Found));
    }

    [Fact]
    public async Task A_move_by_hand_whose_motor_did_not_come_along_is_not_called_done()
    {
        await using var bench = new SimulatedBench();
        bench.Controller.HoldMotor(1, true);
        await using var session = await bench.OpenAsync();

        var result = await JobRunner.GoToAsync(MotionPrograms.LongLine(1000), new CountsPoint(3000, 2000), session, SimulatedBench.Job, null, CancellationToken.None);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("following error in counts: Y 2000", result.Message, StringComparison.Ordinal);
        Assert.NotEqual("", result.PositionDoubt);
    }

    /// <summary>A servo that lags its command by a time constant reaches its position after the end of the motion, and is waited for.</summary>
    [Fact]
    public async Task A_motor_that_settles_late_is_waited_for()
    {
        await using var bench = new SimulatedBench(lag: TimeSpan.FromMilliseconds(60));
        await using var session = await bench.OpenAsync();

        var result = await JobRunner.GoToAsync(MotionPrograms.LongLine(1000), new CountsPoint(30000, 9000), session, SimulatedBench.Job, null, CancellationToken.None);

        Assert.True(result.Outcome == JobOutcome.Complete, result.Message);
    }
}
