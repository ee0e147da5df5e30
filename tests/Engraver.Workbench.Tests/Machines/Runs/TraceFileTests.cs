using Engraver.Core.Machines;
using Engraver.Core.Plots;
using Engraver.Core.Verification;
using Engraver.Galil.Language;
using Engraver.Simulator;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Tests.Machines.Runs;

/// <summary>The trace of the machine is saved beside the journal: from the record of a simulated machine, from polled positions of a real one.</summary>
public sealed class TraceFileTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-trace-");

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_run_leaves_the_places_where_the_machine_was(bool isSimulated)
    {
        await using var bench = await MachineBench.ConnectedAsync();
        var job = MachineBench.Job();
        MachineRunOptions Options(ControllerAddress address) => new(address, JobMode.Stream.Strategy()) { JournalPath = Path.Combine(_folder.FullName, "run.jsonl") };
        var report = isSimulated
            ? await bench.Machine.Runs.SimulateAsync(job, job.Motion.Program!, Options, bench.Limit)
            : await bench.Machine.Runs.RunAsync(job, job.Motion.Program!, Options, bench.Limit);
        Assert.True(report.Result.Outcome == JobOutcome.Complete, report.Result.Message);

        var kept = TraceFile.Read(Path.Combine(_folder.FullName, "run.jsonl"));
        Assert.Equal(isSimulated ? "record" : "polled", kept.Source);
        var cut = kept.Places.Where(place => place.ToolOn).ToList();
        Assert.Equal(45.0, cut.Max(place => place.Place.X), 1);
        Assert.True(cut.Max(place => place.DeviationMm) <= RunJudge.Tolerances(job).Deviation + 0.002);
        Assert.Equal(report.Judgement.MaxDeviationMm!.Value, report.Trace!.Places.Max(place => place.DeviationMm), 3);
        Assert.Same(job, bench.Machine.Runs.Recorded!.Job);
    }

    /// <summary>Motors that trail their command by 20 ms are behind it by feed times 20 ms, whether the controller is polled over a network or its record is
    /// used.</summary>
    [Fact]
    public async Task The_following_error_is_what_the_motors_trail_by_and_is_kept()
    {
        await using var bench = await MachineBench.ConnectedAsync(new SimulatorOptions { Speed = double.PositiveInfinity, ServoLag = TimeSpan.FromMilliseconds(20) });
        var job = MachineBench.Job();
        var journal = Path.Combine(_folder.FullName, "run.jsonl");
        var report = await bench.Machine.Runs.RunAsync(job, job.Motion.Program!, address => new(address, JobMode.Stream.Strategy()) { JournalPath = journal }, bench.Limit);
        Assert.True(report.Result.Outcome == JobOutcome.Complete, report.Result.Message);

        var kept = TraceFile.Read(journal);
        var trail = job.Settings.Machine.FeedMmPerMinute / 60.0 * 0.020;
        Assert.True(kept.HasFollowing);
        Assert.InRange(kept.Places.Where(place => place.ToolOn).Max(place => place.FollowingMm!.Value), 0.9 * trail, 1.2 * trail);
        Assert.Equal(1.0, new RecordedRun(job, kept).Colours(RunMeasure.Following).Where((_, i) => kept.Places[i].ToolOn).Max(), 9);
        Assert.NotEqual(new RecordedRun(job, kept).Colours(RunMeasure.Following), new RecordedRun(job, kept).Colours(RunMeasure.Speed));
        Assert.True(kept.CanBeOf(DrawnFingerprint.Of(job.Analysed.ToSegments())));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task While_a_job_or_a_dry_run_goes_on_its_trace_grows(bool isDryRun)
    {
        await using var bench = await MachineBench.ConnectedAsync();
        var job = MachineBench.Job();
        var seen = new List<int>();
        bench.Machine.Changed += (_, _) =>
        {
            if (bench.Machine is { IsRunning: true, Runs.Recorded: { } recorded }) seen.Add(recorded.Trace.Places.Count(place => place.ToolOn));
        };
        await bench.Machine.Runs.RunAsync(job, job.Motion.Program!, address => new(address, JobMode.Stream.Strategy()) { JournalPath = Path.Combine(_folder.FullName, "run.jsonl"), DryRun = isDryRun }, bench.Limit);

        var growth = seen.Distinct().ToList();
        Assert.True(growth.Count > 5, string.Join(' ', growth));
        Assert.Equal(growth.Order(), growth);
        Assert.All(bench.Machine.Runs.Recorded!.Trace.Places.Where(place => place.ToolOn), place => Assert.InRange(place.DeviationMm, 0.0, RunJudge.Tolerances(job).Deviation + 0.002));
    }

    [Fact]
    public async Task A_trace_that_cannot_be_kept_is_said_and_the_run_is_complete_all_the_same()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        var job = MachineBench.Job();
        var journal = Path.Combine(_folder.FullName, "run.jsonl");
        Directory.CreateDirectory(TraceFile.PathOf(journal)); // Where the file should be.
        var told = new List<string>();

        var report = await bench.Machine.Runs.RunAsync(job, job.Motion.Program!, address => new(address, JobMode.Stream.Strategy()) { JournalPath = journal, FindingReported = finding => told.Add(finding.Id) }, bench.Limit);

        Assert.Equal((JobOutcome.Complete, "JOB0020"), (report.Result.Outcome, Assert.Single(told)));
        Assert.NotEmpty(report.Trace!.Places);
    }

    public void Dispose() => _folder.Delete(recursive: true);
}
