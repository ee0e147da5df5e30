using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Timing;
using Engraver.Galil.Language;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>The operator's overrides change the running job. Checked by the simulator's record.</summary>
public class OverrideTests
{
    private const int Network = 0;

    [Theory]
    [InlineData(JobMode.Stream, 0.5, Network)]
    [InlineData(JobMode.Stream, 2.0, Network)]
    [InlineData(JobMode.Calls, 0.5, Network)]
    [InlineData(JobMode.Calls, 1.5, 19200)]
    [InlineData(JobMode.Program, 0.1, Network)]
    [InlineData(JobMode.Program, 2.0, 19200)]
    public async Task The_feed_changes_in_the_middle_of_a_cut(JobMode mode, double ratio, int baud)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongLine(100000);
        var operators = new HoldingOperator(bench, _ => false, 0.0);
        var change = new CancelWhen(now => now.X > 40000, () => operators.Control.FeedRatio = ratio);

        var result = await HoldTests.RunAsync(bench, program, mode, baud, operators, also: change);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.Equal(20000, FastestNear(bench, 35000), 100.0);
        Assert.Equal(20000 * ratio, FastestNear(bench, 80000), 100.0);
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task What_is_asked_for_before_the_start_holds_from_the_first_cut_and_rapid(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongLine(50000) with { Strokes = [.. MotionPrograms.LongLine(50000).Strokes, .. MotionPrograms.LongRapid(60000).Strokes] };
        var operators = new HoldingOperator(bench, _ => false, 0.0) { Control = { FeedRatio = 0.5, RapidRatio = 0.25 } };

        var result = await HoldTests.RunAsync(bench, program, mode, Network, operators);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.Equal(10000, FastestNear(bench, 25000, cutting: true), 100.0);
        Assert.Equal(12500, FastestNear(bench, 55000, cutting: false), 400.0);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_rapid_under_way_is_slowed_too(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongRapid(100000);
        var operators = new HoldingOperator(bench, _ => false, 0.0);
        var change = new CancelWhen(now => now.X > 30000, () => operators.Control.RapidRatio = 0.2);

        var result = await HoldTests.RunAsync(bench, program, mode, Network, operators, also: change);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.Equal(50000, FastestNear(bench, 25000, cutting: false), 400.0);
        Assert.Equal(10000, FastestNear(bench, 70000, cutting: false), 400.0);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task An_arc_is_cut_no_faster_than_its_acceleration_allows(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.ArcChain(2, 5000); // 20000 counts/s and 256000 counts/s2: 1.78 times the plan at most
        var operators = new HoldingOperator(bench, _ => false, 0.0) { Control = { FeedRatio = 2.0 } };

        var result = await HoldTests.RunAsync(bench, program, mode, Network, operators);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        var record = bench.Controller.Record.Snapshot().Where(sample => sample.Outputs != 0).ToList();
        var fastest = record.Zip(record.Skip(1)).Where(pair => pair.Second.Sample == pair.First.Sample + 1).Max(pair => Math.Sqrt(Math.Pow(pair.Second.A - pair.First.A, 2) + Math.Pow(pair.Second.B - pair.First.B, 2)));
        Assert.InRange(fastest, 32.0, 36.0); // counts in a sample: 1.7 times 20, rounded to whole counts
    }

    /// <summary>Circles of five sizes, a polygon of gentle and one of sharper bends, a long line: each is cut at its highest possible speed.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task At_200_percent_no_sample_exceeds_the_acceleration_in_arcs_along_the_path_and_at_joints(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = Shapes(mode);
        var operators = new HoldingOperator(bench, _ => false, 0.0) { Control = { FeedRatio = 2.0 } };

        var result = await HoldTests.RunAsync(bench, program, mode, Network, operators);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        HoldRecord.AssertEverythingWasCut(bench, program);
        var record = bench.Controller.Record.Snapshot().Where(sample => sample.Outputs != 0).ToList();
        foreach (var stroke in program.Strokes)
        {
            var cut = record.Where(sample => sample.B >= stroke.Start.Y - 8000 && sample.B < stroke.Start.Y + 12000).ToList();
            var planned = stroke.Sequences[0].Speed;
            var fastest = Fastest(cut);
            Assert.InRange(fastest, planned * 0.9, planned * 2.02);
            if (stroke.Sequences[0].Segments[0] is { Kind: VectorSegmentKind.Arc, Radius: var radius }) Assert.InRange(fastest * fastest / radius, 0.0, 256000 * 1.02);
            Assert.InRange(LargestJump(cut), 0.0, Math.Max(2.0 * 20000 * Math.Sin(5.0 * Math.PI / 180.0), 256000 * 0.005) * 1.1);
        }

        Assert.Equal(40000, Fastest(record.Where(sample => sample.B > 130000).ToList()), 300.0); // the long line
        if (mode == JobMode.Stream) Assert.InRange(Fastest(record.Where(sample => Math.Abs(sample.B - 100000) < 9000).ToList()), 19000, 20300); // bends of 8 degrees allow no more than planned; a call ends at rest
    }

    [Theory]
    [InlineData(JobMode.Stream, 0.5, 1.0)]
    [InlineData(JobMode.Stream, 2.0, 0.5)]
    [InlineData(JobMode.Calls, 0.3, 0.4)]
    [InlineData(JobMode.Program, 0.5, 0.5)]
    public async Task The_planned_time_follows_the_overrides(JobMode mode, double feed, double rapid)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongLine(200000) with { Strokes = [.. MotionPrograms.LongLine(200000).Strokes, .. MotionPrograms.LongRapid(150000).Strokes] };
        var planned = JobTime.Estimate(program, null, mode);
        var operators = new HoldingOperator(bench, _ => false, 0.0) { Control = { FeedRatio = feed, RapidRatio = rapid } };

        var result = await HoldTests.RunAsync(bench, program, mode, Network, operators);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.InRange(planned.Under(feed, rapid), 0.96 * result.Seconds, 1.04 * result.Seconds);
        Assert.False(Math.Abs(planned.Total - result.Seconds) < 0.05 * result.Seconds); // the plan itself is far off
    }

    private static MotionProgram Shapes(JobMode mode)
    {
        var strokes = new List<MotionStroke>();
        foreach (var (radius, speed) in new[] { (600, 6000), (1600, 20000), (2500, 20000), (4000, 20000), (7000, 20000) })
            Add(new VectorSegment(VectorSegmentKind.Arc, new(0, strokes.Count * 20000), radius, 180, 360, 0, 2.0 * Math.PI * radius), speed);
        AddBends(8.0);
        AddBends(4.0);
        Add(MotionPrograms.Line(60000, strokes.Count * 20000, 0, 60000), 20000);
        return new MotionProgram(MachineProfile.Default, default, strokes) { Style = mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous };

        void Add(VectorSegment segment, int speed)
        {
            var start = new CountsPoint(0, strokes.Count * 20000);
            strokes.Add(new MotionStroke(strokes.Count, start, [new VectorSequence(start, speed, [segment])]));
        }

        void AddBends(double degrees)
        {
            var (start, at, segments) = (new CountsPoint(0, strokes.Count * 20000), new CountsPoint(0, strokes.Count * 20000), new List<VectorSegment>());
            for (var i = 0; i < 16; i++)
            {
                var to = CountsScale.Round(new Point2D(at.X + (3000.0 * Math.Cos((i % 2 == 0 ? 0.0 : degrees) * Math.PI / 180.0)), at.Y + (3000.0 * Math.Sin((i % 2 == 0 ? 0.0 : degrees) * Math.PI / 180.0))));
                segments.Add(MotionPrograms.Line(to.X, to.Y, 0, new Point2D(at.X, at.Y).DistanceTo(new Point2D(to.X, to.Y))));
                at = to;
            }

            strokes.Add(new MotionStroke(strokes.Count, start, [new VectorSequence(start, 20000, segments)]));
        }
    }

    /// <summary>Highest speed over 20 samples, counts/s.</summary>
    private static double Fastest(IReadOnlyList<MotionSample> record) => Speeds(record, 20).Select(way => double.Hypot(way.X, way.Y)).Max();

    /// <summary>The largest change of velocity over a few samples, counts/s: at a joint the jump, and the ramp of those samples.</summary>
    private static double LargestJump(IReadOnlyList<MotionSample> record)
    {
        var speeds = Speeds(record, 5).ToList();
        return speeds.Zip(speeds.Skip(5)).Select(pair => double.Hypot(pair.Second.X - pair.First.X, pair.Second.Y - pair.First.Y)).DefaultIfEmpty(0.0).Max();
    }

    private static IEnumerable<(double X, double Y)> Speeds(IReadOnlyList<MotionSample> record, int samples) => record.Zip(record.Skip(samples))
        .Where(pair => pair.Second.Sample == pair.First.Sample + samples)
        .Select(pair => ((pair.Second.A - pair.First.A) * 1000.0 / samples, (pair.Second.B - pair.First.B) * 1000.0 / samples));

    [Fact]
    public async Task Hold_and_override_stand_in_the_journal_with_their_place()
    {
        await using var bench = new SimulatedBench();
        var path = Path.Combine(Path.GetTempPath(), $"override-{Guid.NewGuid():N}.jsonl");
        try
        {
            var operators = new HoldingOperator(bench, now => now.X > 60000, 1.0);
            var change = new CancelWhen(now => now.X > 30000, () => operators.Control.FeedRatio = 0.7);

            await HoldTests.RunAsync(bench, MotionPrograms.LongLine(100000), JobMode.Stream, Network, operators, also: change, journal: path);

            var lines = File.ReadLines(path).Where(line => line.Contains("\"kind\":\"control\"", StringComparison.Ordinal)).ToList();
            Assert.Contains("\"phase\":\"running\",\"feed\":0.7,\"rapid\":1,\"x\":3", lines[0], StringComparison.Ordinal);
            Assert.Equal(["holding", "held", "resuming", "running"], lines.Skip(1).Select(line => line.Split('"')[3]));
        }
        finally
        {
            File.Delete(path);
        }
    }

    /// <summary>Speed over some samples around this X, counts/s of the longer axis.</summary>
    private static double FastestNear(SimulatedBench bench, int x, bool? cutting = null)
    {
        var record = bench.Controller.Record.Snapshot().Where(sample => cutting is null || sample.Outputs != 0 == cutting).ToList();
        var at = record.FindIndex(sample => sample.A >= x);
        var (first, last) = (record[at], record[Math.Min(at + 20, record.Count - 1)]);
        return (last.A - first.A) * 1000.0 / (last.Sample - first.Sample);
    }
}
