using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>An interrupted job is resumed from its journal and the controller's counters: nothing is omitted, and only the lead-in and the part after the last
/// poll are cut twice.</summary>
public sealed class ResumeTests : IDisposable
{
    private const double LeadIn = 500.0;

    /// <summary>Feed times the age of the last poll: a job over a network polls every few dozen milliseconds.</summary>
    private const double SinceLastPoll = 20.0 * 60.0;

    private readonly string _folder = Directory.CreateTempSubdirectory("resume").FullName;

    public static TheoryData<JobMode> Modes => [JobMode.Stream, JobMode.Calls, JobMode.Program];

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_stopped_job_goes_on_where_it_was_cut_last(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongLine(100000);
        using var stop = new CancellationTokenSource();

        var first = await RunAsync(bench, program, mode, "a", default, new CancelWhen(now => now.X > 40000, stop.Cancel), stop.Token);
        var found = await FindAsync(bench, program, mode, "a");
        var second = await RunAsync(bench, program, mode, "b", found, null, CancellationToken.None);

        Assert.Equal((JobOutcome.Stopped, JobOutcome.Complete), (first.Outcome, second.Outcome));
        Assert.True(found.IsSameZero);
        Assert.Equal((0, 1), (found.Place.Segments, second.SegmentsExecuted));
        Assert.InRange(found.Place.Along, 37000, 40500);
        Assert.Equal(100000, Assert.Single(second.LengthByStroke), 2.0);
        HoldRecord.AssertEverythingWasCut(bench, program);
        HoldRecord.AssertNoRepeatedCut(bench, program, LeadIn + SinceLastPoll);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task After_the_host_died_the_watchdogs_variables_tell_the_place(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongLine(200000);
        await DieAsync(bench, program, mode, "a", now => now.X > 40000);

        var found = await FindAsync(bench, program, mode, "a");
        var tripped = bench.Controller.Record.Snapshot().Last(sample => sample.Outputs != 0).A;
        var second = await RunAsync(bench, program, mode, "b", found, null, CancellationToken.None);

        Assert.True(found.IsSameZero);
        Assert.InRange(tripped, 55000, 75000); // it continued for a second
        Assert.Equal(tripped - 1000, found.Place.Along, 120.0);
        Assert.Equal(JobOutcome.Complete, second.Outcome);
        HoldRecord.AssertEverythingWasCut(bench, program);
        HoldRecord.AssertNoRepeatedCut(bench, program, LeadIn + found.Doubt + 120.0);
    }

    [Fact]
    public async Task After_a_power_cycle_the_journal_alone_tells_the_place()
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongLine(200000);
        await DieAsync(bench, program, JobMode.Stream, "a", now => now.X > 40000);
        await using var fresh = new SimulatedBench();

        var found = await FindAsync(fresh, program, JobMode.Stream, "a");

        Assert.False(found.IsSameZero);
        Assert.InRange(found.Place.Along, 30000, 40500);
        Assert.Equal(0.0, found.Doubt);
    }

    [Fact]
    public async Task A_resumed_job_that_is_interrupted_again_is_resumed_from_its_own_journal()
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.ShortLines(1200);
        JobResult result;
        ResumePosition? from = null;
        var runs = 0;
        do
        {
            using var stop = new CancellationTokenSource();
            var stopAt = 10000 + (9000 * runs);
            result = await RunAsync(bench, program, JobMode.Stream, $"j{runs}", from, new CancelWhen(now => now.X > stopAt, stop.Cancel), stop.Token);
            if (result.Outcome == JobOutcome.Stopped) from = await FindAsync(bench, program, JobMode.Stream, $"j{runs}");
            Assert.InRange(++runs, 1, 20);
        }
        while (result.Outcome == JobOutcome.Stopped);

        Assert.Equal((JobOutcome.Complete, 1200), (result.Outcome, result.SegmentsExecuted));
        Assert.InRange(runs, 6, 10);
        HoldRecord.AssertEverythingWasCut(bench, program);
        HoldRecord.AssertNoRepeatedCut(bench, program, (runs - 1) * (LeadIn + SinceLastPoll));
    }

    /// <summary>In the lead-in the controller counts segments that the earlier job has cut.</summary>
    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_resumed_job_that_is_interrupted_in_its_lead_in_is_resumed_from_the_same_place(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.ShortLines(60, step: 300) with { Style = mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous };
        using var stop = new CancellationTokenSource();
        using var again = new CancellationTokenSource();
        await RunAsync(bench, program, mode, "a", default, new CancelWhen(now => now.SegmentsExecuted >= 8, stop.Cancel), stop.Token);
        var found = await FindAsync(bench, program, mode, "a");

        var second = await RunAsync(bench, program, mode, "b", found, new CancelWhen(now => now.ToolOn && now.IsOnPath, again.Cancel), again.Token);
        var same = await FindAsync(bench, program, mode, "b");
        var third = await RunAsync(bench, program, mode, "c", same, null, CancellationToken.None);

        Assert.Equal(JobOutcome.Stopped, second.Outcome);
        Assert.True(second.SegmentsExecuted < found.Place.Segments, second.SegmentsExecuted.ToString(System.Globalization.CultureInfo.InvariantCulture));
        Assert.Null(same.Refusal);
        Assert.Equal(found.Place, same.Place);
        Assert.Equal((JobOutcome.Complete, 60), (third.Outcome, third.SegmentsExecuted));
        HoldRecord.AssertEverythingWasCut(bench, program);
    }

    [Theory]
    [InlineData("other")]
    [InlineData("mode")]
    [InlineData("complete")]
    [InlineData("dry")]
    [InlineData("none")]
    [InlineData("missing")]
    public async Task A_journal_that_does_not_fit_is_refused_with_its_reason(string what)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongLine(20000);
        using var stop = new CancellationTokenSource();
        if (what == "none") await File.WriteAllTextAsync(PathOf("a"), "no journal\n");
        else if (what != "missing") await RunAsync(bench, program, JobMode.Stream, "a", default, what == "complete" ? null : new CancelWhen(now => now.X > 9000, stop.Cancel), stop.Token, dryRun: what == "dry");

        var found = await FindAsync(bench, what == "other" ? MotionPrograms.LongLine(20001) : program, what == "mode" ? JobMode.Calls : JobMode.Stream, "a");

        var reason = what switch { "other" => "so the path differs", "mode" => "mode stream, not in mode calls", "complete" => "nothing is left", "dry" => "dry run", "none" => "no job", _ => "cannot be read" };
        Assert.Contains(reason, found.Refusal, StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_stop_at_the_end_of_a_stroke_that_lies_on_the_next_one_leaves_nothing_out(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = new MotionProgram(MachineProfile.Default, default, // a T: the first stroke ends in the middle of the second
        [
            new MotionStroke(0, new(10000, 5000), [new VectorSequence(new(10000, 5000), 20000, [MotionPrograms.Line(10000, 0, 0, 5000)])]),
            new MotionStroke(1, new(0, 0), [new VectorSequence(new(0, 0), 20000, [MotionPrograms.Line(20000, 0, 1, 20000)])]),
        ]);
        using var stop = new CancellationTokenSource();

        var first = await RunAsync(bench, program, mode, "a", default, new CancelWhen(now => now is { X: < 6000, SegmentsExecuted: 1, ToolOn: false }, stop.Cancel), stop.Token);
        var found = await FindAsync(bench, program, mode, "a");
        var second = await RunAsync(bench, program, mode, "b", found, null, CancellationToken.None);

        Assert.Equal((JobOutcome.Stopped, JobOutcome.Complete), (first.Outcome, second.Outcome));
        HoldRecord.AssertEverythingWasCut(bench, program);
    }

    [Fact]
    public async Task A_move_by_hand_between_does_not_lose_the_place()
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongLine(200000);
        await DieAsync(bench, program, JobMode.Stream, "a", now => now.X > 40000);
        var before = await FindAsync(bench, program, JobMode.Stream, "a");
        await using (var session = await bench.OpenAsync())
            Assert.Equal(JobOutcome.Complete, (await JobRunner.GoToAsync(program with { Strokes = [] }, new CountsPoint(-5000, 7000), session, SimulatedBench.Job, null, CancellationToken.None)).Outcome);

        var found = await FindAsync(bench, program, JobMode.Stream, "a");

        Assert.Equal(before, found);
        Assert.Equal(JobOutcome.Complete, (await RunAsync(bench, program, JobMode.Stream, "b", found, null, CancellationToken.None)).Outcome);
        HoldRecord.AssertEverythingWasCut(bench, program);
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private string PathOf(string name) => Path.Combine(_folder, name + ".jsonl");

    private async Task<JobResult> RunAsync(SimulatedBench bench, MotionProgram program, JobMode mode, string journal, ResumePosition? from, IProgress<JobProgress>? progress, CancellationToken stop, bool dryRun = false)
    {
        var options = SimulatedBench.Job with { Strategy = mode.Strategy(), JournalPath = PathOf(journal), Frame = default(CountsPoint), DryRun = dryRun, Address = "bench" };
        if (from is not null) options = options with { From = from.Place, LeadIn = LeadIn + from.Doubt };
        return await bench.RunAsync(program, options, progress, stop);
    }

    private async Task<ResumePosition> FindAsync(SimulatedBench bench, MotionProgram program, JobMode mode, string journal)
    {
        await using var session = await bench.OpenAsync();
        return await ResumeFinder.FindAsync(session.Commands, program, mode, PathOf(journal), CancellationToken.None);
    }

    /// <summary>The host is lost in the middle of the job: nothing more is sent to the controller, and the watchdog trips.</summary>
    private async Task DieAsync(SimulatedBench bench, MotionProgram program, JobMode mode, string journal, Func<JobProgress, bool> when)
    {
        var died = new CancelWhen(when, () =>
        {
            bench.Controller.DropConnections();
            bench.Controller.Advance(TimeSpan.FromSeconds(3));
        });
        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy(), JournalPath = PathOf(journal), Frame = default(CountsPoint), Address = "bench" }, died);
        Assert.Equal(JobOutcome.LinkLost, result.Outcome);
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));
        var lines = await File.ReadAllLinesAsync(PathOf(journal));
        await File.WriteAllLinesAsync(PathOf(journal), lines.Where(line => !line.Contains("\"kind\":\"end\"", StringComparison.Ordinal))); // a lost host does not write the end
    }
}
