using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Jobs.Execution;

/// <summary>The cut length of the unfinished segment: as reported by the controller, never more than was cut.</summary>
public class UnfinishedSegmentTests
{
    private const double Tolerance = 4.0;

    [Theory]
    [InlineData(JobMode.Stream, "line")]
    [InlineData(JobMode.Calls, "line")]
    [InlineData(JobMode.Program, "line")]
    [InlineData(JobMode.Stream, "arc")]
    [InlineData(JobMode.Calls, "arc")]
    public async Task A_stopped_job_tells_how_far_it_came_on_a_long_segment(JobMode mode, string kind)
    {
        await using var bench = new SimulatedBench();
        var program = kind == "line" ? MotionPrograms.LongLine(200000) : MotionPrograms.ArcChain(1, 60000);
        using var stop = new CancellationTokenSource();
        var pressed = 0;
        var press = new CancelWhen(progress => progress.X > 50000, () =>
        {
            pressed = bench.Last.A;
            stop.Cancel();
        });
        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy() }, press, stop.Token);
        var cut = UnfinishedSegment.CutLength(program, result, Tolerance);
        var expected = kind == "line" ? pressed - 1000.0 : 60000.0 * Math.Acos(1.0 - (pressed / 60000.0));

        Assert.Equal((JobOutcome.Stopped, 0), (result.Outcome, result.SegmentsExecuted));
        Assert.InRange(cut, expected - 500.0, expected + 50.0); // a poll is some ten milliseconds old, 20 counts each
        Assert.InRange(cut, 0.0, LengthOf(bench));
    }

    [Fact]
    public async Task A_job_that_was_cut_whole_has_no_unfinished_segment()
    {
        await using var bench = new SimulatedBench();

        Assert.Equal(0.0, UnfinishedSegment.CutLength(MotionPrograms.Paper, await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job), Tolerance));
    }

    [Theory]
    [InlineData(5000, 0, true, 0, 4000.0)]
    [InlineData(5000, 0, false, 0, 0.0)] // the tool was off
    [InlineData(5000, 9, true, 0, 0.0)] // beside the segment
    [InlineData(5000, 0, true, 1, 0.0)] // a segment that was finally not counted
    [InlineData(900000, 0, true, 0, 0.0)] // after its end
    public void Only_a_position_on_the_segment_with_the_tool_on_counts(int x, int y, bool toolOn, int executed, double cut)
    {
        var result = JobResult.NotStarted(MotionPrograms.LongLine(200000).Strokes.Count, "Stopped.") with { PolledTrace = [new TracePoint(1.0, new CountsPoint(x, y), toolOn) { Executed = executed }] };

        Assert.Equal(cut, UnfinishedSegment.CutLength(MotionPrograms.LongLine(200000), result, Tolerance));
    }

    [Theory]
    [InlineData(0, 0, 0.0)] // a full turn starts and ends here
    [InlineData(-1000, 1000, 0.25)]
    [InlineData(-2000, 0, 0.5)]
    [InlineData(-1000, -1000, 0.75)]
    public void A_whole_turn_is_counted_in_its_direction(int x, int y, double fraction)
    {
        foreach (var turn in (double[])[360.0, -360.0])
        {
            var length = 2000.0 * Math.PI;
            var circle = new VectorSequence(default, 20000, [new VectorSegment(VectorSegmentKind.Arc, default, 1000, 0.0, turn, 0, length)]);
            var program = MotionPrograms.LongLine(1) with { Strokes = [new MotionStroke(0, default, [circle])] };
            var result = JobResult.NotStarted(program.Strokes.Count, "Stopped.") with { PolledTrace = [new TracePoint(1.0, new CountsPoint(x, Math.Sign(turn) * y), ToolOn: true)] };

            Assert.Equal(fraction * length, UnfinishedSegment.CutLength(program, result, Tolerance), 6);
        }
    }

    /// <summary>The path of the motors with the tool on, by the record.</summary>
    private static double LengthOf(SimulatedBench bench)
    {
        var rows = bench.Controller.Record.Snapshot();
        return rows.Zip(rows.Skip(1)).Where(pair => pair.First.Outputs != 0).Sum(pair => Math.Sqrt(Math.Pow(pair.Second.A - pair.First.A, 2) + Math.Pow(pair.Second.B - pair.First.B, 2)));
    }
}
