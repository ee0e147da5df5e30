using Engraver.Galil.Jobs;
using Engraver.Galil.Links;
using Engraver.Galil.Sessions;
using Engraver.Galil.Tests.Links;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs;

public class WatchdogLimitTests
{
    [Theory]
    [InlineData(1.024, 1.05, 20)] // a real controller
    [InlineData(0.1, 40.0, 20)] // its answer was held up: nothing is proved
    [InlineData(3.0, 3.1, 20)]
    [InlineData(98.0, 101.0, 2020)]
    [InlineData(100.0, 5000.0, 2500)] // an estimate that a delay has spoiled
    public void Only_a_clock_that_is_proved_to_run_ahead_winds_the_watchdog_further(double proved, double estimated, int ticks) =>
        Assert.Equal(ticks, WatchdogLimit.Of(proved, estimated).Ticks);

    [Theory]
    [InlineData(1.0, JobMode.Stream)]
    [InlineData(20.0, JobMode.Program)]
    [InlineData(100.0, JobMode.Stream)]
    [InlineData(100.0, JobMode.Calls)]
    [InlineData(1000.0, JobMode.Stream)]
    [InlineData(1000.0, JobMode.Program)]
    public async Task At_any_speed_a_host_may_be_held_up_for_most_of_a_second_of_the_wall(double speed, JobMode mode)
    {
        var (result, _) = await RunHeldUpAsync(speed, mode, TimeSpan.FromSeconds(0.6));

        Assert.Equal((JobOutcome.Complete, null), (result.Outcome, result.Loss));
        Assert.Equal(1, result.SegmentsExecuted);
    }

    [Theory]
    [InlineData(1.5, JobMode.Stream, 0.4)]
    [InlineData(2.0, JobMode.Stream, 0.3)]
    [InlineData(2.0, JobMode.Calls, 0.3)]
    [InlineData(2.9, JobMode.Stream, 0.2)]
    [InlineData(2.9, JobMode.Calls, 0.2)]
    [InlineData(2.9, JobMode.Program, 0.2)]
    public async Task Where_the_clock_runs_ahead_by_less_than_is_measured_a_host_in_time_trips_nothing(double speed, JobMode mode, double held)
    {
        var (result, _) = await RunHeldUpAsync(speed, mode, TimeSpan.FromSeconds(held));

        Assert.Equal((JobOutcome.Complete, null), (result.Outcome, result.Loss));
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(2.0)]
    [InlineData(2.9)]
    [InlineData(5.0)]
    public async Task A_host_that_is_silent_for_longer_finds_the_machine_stopped_by_the_watchdog(double speed)
    {
        var (result, controller) = await RunHeldUpAsync(speed, JobMode.Stream, TimeSpan.FromSeconds(1.6));

        Assert.Equal((JobOutcome.LinkLost, LinkLoss.Watchdog), (result.Outcome, result.Loss));
        Assert.Equal(0, controller.Outputs);
    }

    [Fact]
    public async Task A_question_that_was_held_up_when_the_clock_was_measured_is_asked_again()
    {
        var questions = 0;
        var (result, _) = await RunHeldUpAsync(200.0, JobMode.Stream, TimeSpan.FromSeconds(0.6), HoldUpTheFirstOfTwo);

        Assert.Equal((JobOutcome.Complete, null), (result.Outcome, result.Loss));

        void HoldUpTheFirstOfTwo(RunningTime time, string line)
        {
            if (line.StartsWith("MG TIME", StringComparison.Ordinal) && ++questions is (1 or 3 or 5)) time.Pass(TimeSpan.FromSeconds(0.3));
        }
    }

    /// <summary>Ten seconds of a cut; in the middle the host does nothing for so long.</summary>
    private static async Task<(JobResult Result, ControllerStatus Status)> RunHeldUpAsync(double speed, JobMode mode, TimeSpan hold, Action<RunningTime, string>? sending = null)
    {
        var time = new RunningTime();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = speed, Time = time.WithoutTimers });
        Action<string>? afterConnect = null;
        await using var session = await ControllerSession.OpenAsync(
            _ => Task.FromResult<IControllerLink>(new WithheldLink(new StreamLink(controller.OpenConnection(), "memory")) { Sending = line => afterConnect?.Invoke(line) }), new SessionOptions(), time, CancellationToken.None);
        if (sending is not null) afterConnect = line => sending(time, line);
        var held = new CancelWhen(progress => progress.X > 3000, () => time.Pass(hold));
        return (await JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, new JobOptions { Mode = mode }, held, CancellationToken.None), controller.Status);
    }
}
