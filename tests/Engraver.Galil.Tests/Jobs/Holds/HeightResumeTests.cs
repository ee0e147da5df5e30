using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>A job with a tool that is moved by an axis is resumed after a stop, a lost host and a power cycle, in lines, arcs, slopes, vertical pieces and
/// plunges: every point is cut in X, Y and Z, and twice only within the limit.</summary>
public sealed class HeightResumeTests : IDisposable
{
    private const double LeadIn = 500.0;

    /// <summary>Feed times the age of the last poll, and the braking path, which is cut as well.</summary>
    private const double SinceLastPoll = (20.0 * 60.0) + 800.0;

    private readonly string _folder = Directory.CreateTempSubdirectory("height-resume").FullName;

    public static TheoryData<JobMode, string> Everywhere => HeightHoldTests.Everywhere;

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task A_stopped_job_goes_on_where_it_was_cut_last(JobMode mode, string where)
    {
        await using var bench = new SimulatedBench();
        var program = Program(mode);
        using var stop = new CancellationTokenSource();

        var first = await RunAsync(bench, program, mode, "a", null, new CancelWhen(HeightHoldTests.At(where), stop.Cancel), stop.Token);
        var second = await RunAsync(bench, program, mode, "b", await FindAsync(bench, program, mode, "a"), null, CancellationToken.None);

        Assert.Equal((JobOutcome.Stopped, "Done: 9 segments."), (first.Outcome, second.Message));
        HeightBench.AssertCut(bench, program, LeadIn + SinceLastPoll);
        HeightBench.AssertGentle(bench, program);
    }

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task After_the_host_died_the_watchdogs_variables_tell_the_place_in_three_axes(JobMode mode, string where)
    {
        await using var bench = new SimulatedBench();
        var program = Program(mode);
        await DieAsync(bench, program, mode, where);

        var found = await FindAsync(bench, program, mode, "a");
        Assert.Null(found.Refusal);
        var second = await RunAsync(bench, program, mode, "b", found, null, CancellationToken.None);

        Assert.True(found.IsSameZero);
        Assert.Equal("Done: 9 segments.", second.Message);
        HeightBench.AssertCut(bench, program, LeadIn + found.Doubt + SinceLastPoll);
        HeightBench.AssertGentle(bench, program);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task After_a_power_cycle_the_journal_alone_tells_the_place_and_the_rest_is_cut(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = Program(mode);
        await DieAsync(bench, program, mode, "slope");
        await using var fresh = new SimulatedBench(); // switched on again; it is at the drawing's zero

        var found = await FindAsync(fresh, program, mode, "a");
        var second = await RunAsync(fresh, program, mode, "b", found, null, CancellationToken.None);

        Assert.False(found.IsSameZero);
        Assert.InRange(found.Place.Segments, 3, 4); // in the slope
        var along = (found.Place.Segments == 3 ? 0.0 : Math.Sqrt(100_640_000.0)) + found.Place.Along - LeadIn;
        Assert.Equal("Done: 9 segments.", second.Message);
        var left = fresh.Controller.Record.Snapshot().First(sample => sample.C < 0);
        Assert.Equal(30000, left.B);
        Assert.Equal(5000.0 + (along * 10000.0 / Math.Sqrt(100_640_000.0)), left.A, 15.0);
        HeightBench.AssertGentle(fresh, program);
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private static MotionProgram Program(JobMode mode) => HeightBench.Part(style: mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous);

    private string PathOf(string name) => Path.Combine(_folder, name + ".jsonl");

    private async Task<JobResult> RunAsync(SimulatedBench bench, MotionProgram program, JobMode mode, string journal, ResumePosition? from, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        var options = SimulatedBench.Job with { Strategy = mode.Strategy(), JournalPath = PathOf(journal), Frame = default(CountsPoint), Address = "bench" };
        if (from is not null) options = options with { From = from.Place, LeadIn = LeadIn + from.Doubt };
        return await bench.RunAsync(program, options, progress, stop);
    }

    private async Task<ResumePosition> FindAsync(SimulatedBench bench, MotionProgram program, JobMode mode, string journal)
    {
        await using var session = await bench.OpenAsync();
        return await ResumeFinder.FindAsync(session.Commands, program, mode, PathOf(journal), CancellationToken.None);
    }

    /// <summary>The host is lost: nothing more is sent to the controller, and the watchdog trips.</summary>
    private async Task DieAsync(SimulatedBench bench, MotionProgram program, JobMode mode, string where)
    {
        var died = new CancelWhen(HeightHoldTests.At(where), () =>
        {
            bench.Controller.DropConnections();
            bench.Controller.Advance(TimeSpan.FromSeconds(3));
        });
        Assert.Equal(JobOutcome.LinkLost, (await RunAsync(bench, program, mode, "a", null, died, CancellationToken.None)).Outcome);
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(20));
        var lines = await File.ReadAllLinesAsync(PathOf("a"));
        await File.WriteAllLinesAsync(PathOf("a"), lines.Where(line => !line.Contains("\"kind\":\"end\"", StringComparison.Ordinal))); // a lost host does not write the end
    }
}
