using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Tests.Links;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>The abort input is activated while a job runs: the machine stops at once, and the job must detect it, switch the tool off and report the reason
/// (galil-dmc.md A.10, D).</summary>
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

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Strategy = mode.Strategy() }, hit);

        Assert.NotEqual(JobOutcome.Complete, result.Outcome);
        Assert.Contains("abort input", result.Message, StringComparison.Ordinal);
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

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Strategy = mode.Strategy() }, hit);

        Assert.NotEqual(JobOutcome.Complete, result.Outcome);
        Assert.Contains("abort input", result.Message, StringComparison.Ordinal);
        Assert.Equal((0, 0, false), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads, bench.Controller.Status.IsMoving));
    }

    /// <summary>An abort stops without a ramp: an encoder still counts the motion of a servo, but the lost steps of a stepper are not counted. The stop code
    /// remains, and does not concern a later job.</summary>
    [Theory]
    [InlineData(JobMode.Stream, "2", true)]
    [InlineData(JobMode.Calls, "-2", true)]
    [InlineData(JobMode.Program, "2", true)]
    [InlineData(JobMode.Stream, "1", false)]
    public async Task The_place_of_steppers_that_an_abort_stopped_is_in_doubt(JobMode mode, string motor, bool isDoubted)
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("MO", $"MTA={motor}", $"MTB={motor}", "SH");
        var hit = new CancelWhen(progress => progress.X > 50000, () => bench.Controller.SetAbortInput(true));

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Strategy = mode.Strategy() }, hit);

        Assert.Equal((isDoubted, isDoubted), (result.PositionDoubt.Contains("may have lost steps", StringComparison.Ordinal), result.Message.Contains("set the work origin again", StringComparison.Ordinal)));

        bench.Controller.SetAbortInput(false);
        using var stop = new CancellationTokenSource();
        var next = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Strategy = mode.Strategy() }, new CancelWhen(progress => progress.X > 60000, stop.Cancel), stop.Token);
        Assert.Equal((JobOutcome.Stopped, ""), (next.Outcome, next.PositionDoubt));
    }

    /// <summary>The controller stops at once when it has no more segments.</summary>
    [Theory]
    [InlineData("2", JobOutcome.Refused)]
    [InlineData("1", JobOutcome.Complete)]
    public async Task A_path_of_steppers_that_ran_dry_is_not_taken_up_again(string motor, JobOutcome outcome)
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("MO", $"MTA={motor}", $"MTB={motor}", "SH");
        var links = new List<WithheldLink>();
        await using var session = await bench.OpenAsync(opened: links.Add);
        var polls = 0;
        links[0].Sending = line =>
        {
            if (line.StartsWith("MG _BGS", StringComparison.Ordinal) && bench.Controller.Status.IsMoving && ++polls % 10 == 0) bench.Controller.Advance(TimeSpan.FromSeconds(0.7)); // less than the limit of the watchdog
        };

        var result = await JobRunner.RunAsync(MotionPrograms.ShortLines(1600), session, SimulatedBench.Job, null, CancellationToken.None);

        Assert.Equal((outcome, outcome == JobOutcome.Refused), (result.Outcome, result.PositionDoubt.Length > 0));
        Assert.InRange(result.Underruns, 1, outcome == JobOutcome.Refused ? 1 : 20);
        Assert.Equal(0, (int)bench.Controller.Status.Outputs);
    }
}
