using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs;

public class RefusalTests
{
    [Fact]
    public async Task A_rapid_towards_a_limit_switch_is_refused_with_the_controllers_reason()
    {
        await using var bench = new SimulatedBench();
        bench.Controller.SetLimitSwitch(0, forward: true, active: true);

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job);

        Assert.Equal((JobOutcome.Refused, TcCode.BeginAgainstLimitSwitch, 1), (result.Outcome, (TcCode?)result.Refusal?.Code, result.Rejected));
        Assert.Contains("TC 22 (Begin not possible due to limit switch)", result.Message, StringComparison.Ordinal);
        Assert.Equal(0, bench.Controller.Status.RunningThreads);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_limit_switch_in_the_middle_of_a_cut_ends_the_job_and_is_named(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var hit = new CancelWhen(progress => progress.X > 50000, () => bench.Controller.SetLimitSwitch(0, forward: true, active: true));

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Strategy = mode.Strategy() }, hit);

        Assert.Equal((JobOutcome.Refused, 0), (result.Outcome, result.SegmentsExecuted));
        Assert.Contains("forward limit switch", result.Message, StringComparison.Ordinal);
        Assert.Equal(0, bench.Last.Outputs);
    }

    [Fact]
    public async Task An_arc_that_the_controller_does_not_take_names_its_entity()
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunAsync(MotionPrograms.ArcChain(3, 5), SimulatedBench.Job);

        Assert.Equal((JobOutcome.Refused, TcCode.NumberOutOfRange), (result.Outcome, (TcCode?)result.Refusal?.Code));
        Assert.Contains("CR 5,180,-180", result.Message, StringComparison.Ordinal);
        Assert.Contains("Drawing entity 0.", result.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task An_arc_that_the_called_program_does_not_take_ends_the_job_with_the_programs_error()
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunAsync(MotionPrograms.ArcChain(3, 5), SimulatedBench.Job with { Strategy = JobMode.Calls.Strategy() });

        Assert.Equal((JobOutcome.Refused, TcCode.NumberOutOfRange), (result.Outcome, (TcCode?)result.Refusal?.Code));
        Assert.Equal((0, 0), (bench.Last.Outputs, bench.Controller.Status.RunningThreads));
    }

    [Fact]
    public async Task Whichever_command_is_refused_the_job_ends_at_rest_with_the_tool_off()
    {
        var refusals = 0;
        for (var command = 60; command < 420; command += 3)
        {
            await using var bench = new SimulatedBench(new FaultPlan { Refusals = [new CommandRefusal(command, 6)] });

            var result = await bench.RunAsync(MotionPrograms.TwoStrokes, SimulatedBench.Job);

            var status = bench.Controller.Status;
            Assert.Equal((false, 0, 0), (status.IsMoving || status.IsSequenceOpen, status.Outputs, status.RunningThreads));
            if (result.Outcome == JobOutcome.Refused) refusals++;
            else Assert.Equal((command, JobOutcome.Complete, result.Message), (command, result.Outcome, result.Message));
        }

        Assert.InRange(refusals, 50, 120);
    }
}
