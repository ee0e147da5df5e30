using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Tests.Programs;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>An override above the programmed feed plans what is not sent again, with the same limits.</summary>
public sealed class FastFeedTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("fast-feed").FullName;

    /// <summary>Zigzags with rounded corners, an arc and a long line: at twice the feed its bends are slower than the feed.</summary>
    private static readonly Segment[][] s_strokes = [Zigzag(0.0), Zigzag(12.0), Zigzag(24.0)];

    [Theory]
    [InlineData(JobMode.Stream, 2.0)]
    [InlineData(JobMode.Stream, 1.37)]
    [InlineData(JobMode.Calls, 2.0)]
    public async Task A_job_at_an_override_takes_the_time_of_one_that_is_planned_for_that_feed(JobMode mode, double ratio)
    {
        await using var bench = new SimulatedBench();
        await using var other = new SimulatedBench();
        var (program, faster) = (Program(mode, 1.0), Program(mode, ratio));

        var result = await RunAsync(bench, program, mode, ratio);
        var wanted = await RunAsync(other, faster, mode, 1.0);

        Assert.Equal((JobOutcome.Complete, program.SegmentCount), (result.Outcome, result.SegmentsExecuted));
        Assert.InRange(result.Seconds, 0.985 * wanted.Seconds, 1.015 * wanted.Seconds);
        Assert.Equal(result.SegmentsExecuted, result.SegmentsSent);
        HoldRecord.AssertEverythingWasCut(bench, program);
        HoldRecord.AssertNoRepeatedCut(bench, program, 0.0);
        Assert.InRange(LargestAcceleration(bench), 0.9 * 256000.0, (1.05 * 256000.0) + (2.0 / (0.009 * 0.009)));
    }

    /// <summary>A sequence that began at a higher override is not slower than the programmed feed when the operator takes the override back.</summary>
    [Fact]
    public async Task An_override_that_is_taken_back_holds_from_the_next_sequence_as_planned()
    {
        await using var bench = new SimulatedBench();
        await using var other = new SimulatedBench();
        var program = Program(JobMode.Stream, 1.0);
        var operators = new HoldingOperator(bench, _ => false, 0.0) { Control = { FeedRatio = 2.0 } };
        var back = new CancelWhen(now => now.Y > 5000, () => operators.Control.FeedRatio = 1.0);

        var result = await HoldTests.RunAsync(bench, program, JobMode.Stream, 0, operators, also: back);
        var planned = await RunAsync(other, program, JobMode.Stream, 1.0);

        Assert.Equal((JobOutcome.Complete, program.SegmentCount), (result.Outcome, result.SegmentsExecuted));
        Assert.InRange(StrokeSeconds(bench, 12000), 0.98 * StrokeSeconds(other, 12000), 1.02 * StrokeSeconds(other, 12000));
        Assert.InRange(StrokeSeconds(bench, 0), 0.4 * StrokeSeconds(other, 0), 0.99 * StrokeSeconds(other, 0));
        HoldRecord.AssertEverythingWasCut(bench, program);
    }

    /// <summary>The host is lost in the middle: what the controller counted are parts of segments, and the rest begins where the tool was.</summary>
    [Theory]
    [InlineData(0.25)]
    [InlineData(0.5)]
    [InlineData(0.75)]
    public async Task A_host_that_is_lost_at_an_override_is_resumed_where_the_tool_stopped(double part)
    {
        await using var bench = new SimulatedBench();
        var program = Program(JobMode.Stream, 1.0);
        var journal = Path.Combine(_folder, "lost.jsonl");
        var operators = new HoldingOperator(bench, _ => false, 0.0) { Control = { FeedRatio = 2.0 } };
        var kill = new CancelWhen(now => now.SegmentsExecuted > part * program.SegmentCount, () =>
        {
            bench.Controller.DropConnections();
            bench.Controller.Advance(TimeSpan.FromSeconds(3));
        });
        var options = SimulatedBench.Job with { Strategy = JobMode.Stream.Strategy(), JournalPath = journal, Frame = default(CountsPoint), Address = "bench", Control = operators.Control };

        var lost = await bench.RunAsync(program, options, kill, CancellationToken.None);
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));
        await using var session = await bench.OpenAsync();
        var found = await ResumeFinder.FindAsync(session.Commands, program, JobMode.Stream, journal, CancellationToken.None);
        await session.DisposeAsync();
        var rest = await bench.RunAsync(program, options with { JournalPath = Path.Combine(_folder, "rest.jsonl"), From = found.Place, LeadIn = 200.0 + found.Doubt }, null, CancellationToken.None);

        Assert.Equal(JobOutcome.LinkLost, lost.Outcome);
        Assert.Null(found.Refusal);
        Assert.Contains(File.ReadLines(journal), line => line.Contains("\"divided\":[", StringComparison.Ordinal));
        Assert.Equal((JobOutcome.Complete, program.SegmentCount), (rest.Outcome, rest.SegmentsExecuted));
        HoldRecord.AssertEverythingWasCut(bench, program);
        HoldRecord.AssertNoRepeatedCut(bench, program, 200.0 + (40.0 * 60.0) + RemainingProgram.WholeCountSearch);
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private static Segment[] Zigzag(double y)
    {
        var (path, at) = (new List<Segment>(), new Point2D(1.0, y));
        foreach (var (length, degrees) in new[] { (4.0, 0.0), (2.0, 50.0), (1.0, -60.0), (6.0, 20.0), (0.6, 80.0), (3.0, 0.0) })
        {
            var to = at + Vector2D.FromPolar(length, Angle.FromDegrees(degrees));
            path.Add(Segment.FromLine(at, to));
            at = to;
        }

        path.Add(Segment.FromArc(new ArcSegment(at + new Vector2D(0.0, 1.2), 1.2, Angle.FromDegrees(-90.0), Angle.FromDegrees(180.0))));
        at += new Vector2D(0.0, 2.4);
        path.Add(Segment.FromLine(at, at + new Vector2D(-15.0, 0.0)));
        return [.. path];
    }

    private static MotionProgram Program(JobMode mode, double ratio) => MotionProgramGenerator.Generate(
        Toolpaths.OfStrokes(s_strokes), MachineProfile.Default with { FeedMmPerMinute = MachineProfile.Default.FeedMmPerMinute * ratio },
        new MotionTolerances(0.001, 0.01), null, mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous).Program!;

    private static Task<JobResult> RunAsync(SimulatedBench bench, MotionProgram program, JobMode mode, double ratio) =>
        HoldTests.RunAsync(bench, program, mode, 0, new HoldingOperator(bench, _ => false, 0.0) { Control = { FeedRatio = ratio } });

    /// <summary>Seconds with the tool on in the stroke that begins at a height.</summary>
    private static double StrokeSeconds(SimulatedBench bench, int y)
    {
        var cut = bench.Controller.Record.Snapshot().Where(sample => sample.Outputs != 0 && sample.B >= y - 100 && sample.B < y + 11000).ToList();
        return (cut[^1].Sample - cut[0].Sample) / 1000.0;
    }

    /// <summary>By the second difference of positions 9 samples apart, counts/s2: the square root of 20 counts over the acceleration.</summary>
    private static double LargestAcceleration(SimulatedBench bench)
    {
        const int H = 9;
        var record = bench.Controller.Record.Snapshot().Where(sample => sample.Outputs != 0).ToList();
        var largest = 0.0;
        for (var i = H; i < record.Count - H; i++)
        {
            if (record[i + H].Sample - record[i - H].Sample != 2 * H) continue;
            largest = Math.Max(largest, double.Hypot(record[i - H].A - (2.0 * record[i].A) + record[i + H].A, record[i - H].B - (2.0 * record[i].B) + record[i + H].B) / (H * H * 1e-6));
        }

        return largest;
    }
}
