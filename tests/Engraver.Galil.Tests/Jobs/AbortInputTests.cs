using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>Somebody hits the abort input while a job runs: the machine stands at once, and the job has to see it, switch the tool off and say why (galil-dmc.md A.10, D).</summary>
public class AbortInputTests
{
    [Theory]
    [InlineData(JobMode.Stream, "0")]
    [InlineData(JobMode.Calls, "0")]
    [InlineData(JobMode.Program, "0")]
    [InlineData(JobMode.Stream, "1")]
    [InlineData(JobMode.Calls, "1")]
    [InlineData(JobMode.Program, "1")]
    public async Task A_job_that_the_abort_input_ended_says_so_with_the_tool_off_and_the_machine_left_as_found(JobMode mode, string programsSpared)
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("CN ,,,," + programsSpared);
        var before = await bench.FingerprintAsync();
        var hit = new CancelWhen(progress => progress.X > 50000, () => bench.Controller.SetAbortInput(true));

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Mode = mode }, hit);

        Assert.NotEqual(JobOutcome.Complete, result.Outcome);
        Assert.Contains("abort input", result.Sentence, StringComparison.Ordinal);
        Assert.Equal((0, 0), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads));
        Assert.False(bench.Controller.Status.IsMoving);
        Assert.Equal(new CountsPoint(bench.Last.A, bench.Last.B), result.FinalPosition);
        Assert.Equal(before, await bench.FingerprintAsync());
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task Hit_while_the_machine_stands_it_is_told_all_the_same(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var hit = new CancelWhen(progress => progress.ToolOn && !bench.Controller.Status.IsMoving, () => bench.Controller.SetAbortInput(true));

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Mode = mode }, hit);

        Assert.NotEqual(JobOutcome.Complete, result.Outcome);
        Assert.Contains("abort input", result.Sentence, StringComparison.Ordinal);
        Assert.Equal((0, 0, false), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads, bench.Controller.Status.IsMoving));
    }
}
