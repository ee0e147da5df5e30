using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Tests.Links;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs;

public class JobRunnerTests
{
    public static TheoryData<JobMode> Modes => [JobMode.Stream, JobMode.Calls, JobMode.Program];

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task The_papers_drawing_ends_on_its_counts_with_the_tool_off(JobMode mode)
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job with { Strategy = mode.Strategy() });

        Assert.Equal("Done: 4 segments.", result.Message);
        Assert.Equal((JobOutcome.Complete, 4, 4, 0, 0), (result.Outcome, result.SegmentsSent, result.SegmentsExecuted, result.Underruns, result.Rejected));
        Assert.Equal(new CountsPoint(5000, 5000), result.FinalPosition);
        Assert.Equal((5000, 5000, 0), (bench.Last.A, bench.Last.B, bench.Last.Outputs));
        Assert.Equal([0, 1, 2, 3], result.ExecutedEntityIndices);
        CutRecord.AssertWholePathWasCut(bench, MotionPrograms.Paper);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task Over_TCP_the_same_bytes_do_the_same(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenTcpAsync();

        var result = await JobRunner.RunAsync(MotionPrograms.Paper, session, SimulatedBench.Job with { Strategy = mode.Strategy() }, null, CancellationToken.None);

        Assert.Equal((JobOutcome.Complete, 4, 0), (result.Outcome, result.SegmentsExecuted, result.Underruns));
        Assert.Equal((5000, 5000, 0), (bench.Last.A, bench.Last.B, bench.Last.Outputs));
        CutRecord.AssertWholePathWasCut(bench, MotionPrograms.Paper);
    }

    [Fact]
    public async Task A_sequence_longer_than_the_buffer_is_fed_without_running_dry()
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.ShortLines(1600);

        var result = await bench.RunAsync(program, SimulatedBench.Job);

        Assert.Equal("Done: 1600 segments.", result.Message);
        Assert.Equal((JobOutcome.Complete, 1600, 1600, 0, 0), (result.Outcome, result.SegmentsSent, result.SegmentsExecuted, result.Underruns, result.Rejected));
        Assert.Equal(new CountsPoint(96000, 0), result.FinalPosition);
        Assert.Equal(0, bench.Controller.Status.Underruns);
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    [Fact]
    public async Task The_tool_is_on_only_from_a_settle_before_to_a_settle_after_the_cut_and_never_in_a_rapid()
    {
        await using var bench = new SimulatedBench();

        await bench.RunAsync(MotionPrograms.TwoStrokes, SimulatedBench.Job);

        var cutting = CutRecord.AssertNothingElseWasCut(bench, MotionPrograms.TwoStrokes);
        var moves = bench.Controller.Record.Snapshot();
        foreach (var stroke in cutting.GroupBy(sample => sample.B))
        {
            var moving = stroke.Zip(stroke.Skip(1)).Where(pair => pair.First.A != pair.Second.A).Select(pair => pair.Second.Sample).ToList();
            var off = moves.First(sample => sample.Sample > moving[^1] && sample.Outputs == 0).Sample;
            Assert.InRange(moving[0] - stroke.First().Sample, 100, 150);
            Assert.InRange(off - moving[^1], 0, 100);
        }
    }

    [Fact]
    public async Task A_dry_run_moves_all_the_way_with_the_tool_off()
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job with { DryRun = true });

        Assert.Equal((JobOutcome.Complete, 4), (result.Outcome, result.SegmentsExecuted));
        Assert.All(bench.Controller.Record.Snapshot(), sample => Assert.Equal(0, sample.Outputs));
    }

    /// <summary>Regression: every one was stored until the end of the job, 28 MB an hour.</summary>
    [Theory]
    [MemberData(nameof(Modes))]
    public async Task Every_polled_position_is_told_while_the_job_runs_and_only_the_last_ones_are_kept(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var told = new List<TracePoint>();

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), SimulatedBench.Job with { Strategy = mode.Strategy(), Polled = told.Add });

        Assert.True(told.Count > 100, $"{told.Count} positions were told");
        Assert.Equal(told.Count, told.Select(point => point.Seconds).Distinct().Count());
        Assert.Equal([told.Last(point => point.ToolOn), told[^1]], result.PolledTrace);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task The_drawing_starts_where_the_machine_stands_whatever_its_zero(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("DPA=-70000", "DPB=123");

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job with { Strategy = mode.Strategy() });

        Assert.Equal(new CountsPoint(-65000, 5123), result.FinalPosition);
        Assert.Equal((5000, 5000), (result.PolledTrace[^1].X, result.PolledTrace[^1].Y));
    }

    [Theory]
    [InlineData(JobMode.Stream, NumberSpacing.Blank)]
    [InlineData(JobMode.Stream, NumberSpacing.SignColumn)]
    [InlineData(JobMode.Calls, NumberSpacing.Blank)]
    [InlineData(JobMode.Calls, NumberSpacing.SignColumn)]
    [InlineData(JobMode.Program, NumberSpacing.Blank)]
    [InlineData(JobMode.Program, NumberSpacing.SignColumn)]
    public async Task Negative_coordinates_are_read_with_and_without_a_blank_before_them(JobMode mode, NumberSpacing spacing)
    {
        await using var bench = new SimulatedBench(spacing: spacing);
        await bench.SendAsync("DPA=-70000", "DPB=-123");

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job with { Strategy = mode.Strategy() });

        Assert.Equal("Done: 4 segments.", result.Message);
        Assert.Equal(new CountsPoint(-65000, 4877), result.FinalPosition);
    }

    [Fact]
    public async Task A_drawing_without_strokes_is_done_at_once()
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunAsync(MotionPrograms.Paper with { Strokes = [] }, SimulatedBench.Job);

        Assert.Equal((JobOutcome.Complete, 0), (result.Outcome, result.SegmentsSent));
    }

    [Fact]
    public async Task Entities_and_strokes_are_told_in_the_order_of_cutting()
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunAsync(MotionPrograms.TwoStrokes, SimulatedBench.Job);

        Assert.Equal([7, 3], result.ExecutedEntityIndices);
        Assert.Equal([1, 1], result.ExecutedByStroke);
        Assert.Equal([2000.0, 2000.0], result.LengthByStroke);
    }

    [Fact]
    public async Task Segments_that_are_cut_faster_than_they_can_be_sent_slow_the_path_down_instead_of_running_dry()
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunAsync(MotionPrograms.ShortLines(3000, step: 20), SimulatedBench.Job);

        Assert.Equal((JobOutcome.Complete, 3000, 0), (result.Outcome, result.SegmentsExecuted, result.Underruns));
        Assert.Equal((60000, 0, 0), (bench.Last.A, bench.Last.B, bench.Controller.Status.Underruns));
    }

    [Fact]
    public async Task A_sequence_that_ran_dry_is_taken_up_again_where_it_stopped()
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.ShortLines(1600);
        var links = new List<WithheldLink>();
        await using var session = await bench.OpenAsync(opened: links.Add);
        var polls = 0;
        links[0].Sending = line =>
        {
            // Less than the limit of the watchdog, repeatedly more than the buffer holds.
            if (line.StartsWith("MG _BGS", StringComparison.Ordinal) && bench.Controller.Status.IsMoving && ++polls % 10 == 0) bench.Controller.Advance(TimeSpan.FromSeconds(0.7));
        };

        var result = await JobRunner.RunAsync(program, session, SimulatedBench.Job, null, CancellationToken.None);

        Assert.Equal((JobOutcome.Complete, 1600, 1600), (result.Outcome, result.SegmentsSent, result.SegmentsExecuted));
        Assert.InRange(result.Underruns, 1, 20);
        Assert.Equal(bench.Controller.Status.Underruns, result.Underruns);
        Assert.Equal(new CountsPoint(96000, 0), result.FinalPosition);
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    /// <summary>A circle that the controller received as two turns ends at the same point: only the length of the path shows the difference, also when the
    /// sequence runs dry after it.</summary>
    [Fact]
    public async Task A_sequence_that_ran_dry_is_not_taken_up_again_when_its_path_was_longer_than_planned()
    {
        await using var bench = new SimulatedBench();
        var links = new List<WithheldLink>();
        await using var session = await bench.OpenAsync(opened: links.Add);
        links[0].Corrupt = line => line.Replace("CR 1500,180,360", "CR 1500,180,720", StringComparison.Ordinal);
        links[0].Sending = line =>
        {
            if (line.StartsWith("MG _BGS", StringComparison.Ordinal) && bench.Controller.Status is { IsMoving: true, Underruns: 0 } && bench.Last.A > 3000) bench.Controller.Advance(TimeSpan.FromSeconds(0.7));
        };

        var result = await JobRunner.RunAsync(MotionPrograms.CircleAndShortLines(1600), session, SimulatedBench.Job, null, CancellationToken.None);

        Assert.Equal((JobOutcome.Deviated, 1, 0), (result.Outcome, result.Underruns, bench.Controller.Status.Outputs));
        Assert.Contains("counts along its path", result.Message, StringComparison.Ordinal);
        Assert.Equal(1, bench.Controller.Status.Underruns); // it ended there
        Assert.True(bench.Last.A < 96000);
    }
}
