using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Protocol;
using Engraver.Galil.Tests.Programs;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Jobs.Execution;

/// <summary>Features of the downloaded job only: chunks, a memory that is too small, lines that fail in the controller.</summary>
public class ProgramStrategyTests
{
    private static readonly JobOptions Job = SimulatedBench.Job with { Strategy = JobMode.Program.Strategy() };

    [Fact]
    public async Task A_job_longer_than_the_default_memory_comes_in_chunks_and_every_stroke_is_cut_whole()
    {
        await using var bench = new SimulatedBench();
        var program = Strokes(240);
        var (result, downloads) = await CountedAsync(bench, program);

        Assert.Equal("Done: 480 segments.", result.Message);
        Assert.Equal((480, 480, 0, 0), (result.SegmentsSent, result.SegmentsExecuted, result.Rejected, result.Diagnostics.Count));
        Assert.InRange(downloads, 4, 5); // the resident program, two or three chunks, the found program
        Assert.Equal(Enumerable.Range(0, 240), result.ExecutedEntityIndices);
        Assert.All(result.ExecutedByStroke, count => Assert.Equal(2, count));
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    [Fact]
    public async Task A_controller_with_less_memory_than_expected_says_so_by_its_refusal_and_gets_smaller_chunks()
    {
        await using var bench = new SimulatedBench(programLines: 130);
        var program = Strokes(60);
        var (result, _) = await CountedAsync(bench, program);

        Assert.Equal((JobOutcome.Complete, 120, 120, 0), (result.Outcome, result.SegmentsSent, result.SegmentsExecuted, result.Rejected));
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    [Fact]
    public async Task A_contour_longer_than_the_memory_goes_on_in_the_next_chunk_and_is_counted_as_one()
    {
        await using var bench = new SimulatedBench(programLines: 130);
        var program = MotionPrograms.ShortLines(1600);
        var (result, downloads) = await CountedAsync(bench, program);

        Assert.Equal((JobOutcome.Complete, 1600, 1600), (result.Outcome, result.SegmentsSent, result.SegmentsExecuted));
        Assert.True(downloads > 4);
        Assert.NotEmpty(result.Diagnostics);
        Assert.All(result.Diagnostics, note => Assert.Equal("MOT0007", note.Id));
        Assert.Equal(1600, Assert.Single(result.ExecutedByStroke));
        Assert.Equal(new CountsPoint(96000, 0), result.FinalPosition);
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    [Fact]
    public async Task A_memory_without_room_for_the_subprograms_is_a_refusal_and_nothing_moves()
    {
        await using var bench = new SimulatedBench(programLines: 40);
        var result = await bench.RunAsync(MotionPrograms.Paper, Job);

        Assert.Equal((JobOutcome.Refused, TcCode.DownloadError, 0), (result.Outcome, (TcCode?)result.Refusal?.Code, result.SegmentsSent));
        Assert.All(bench.Controller.Record.Snapshot(), sample => Assert.Equal((0, 0), (sample.A, sample.B)));
    }

    [Fact]
    public async Task Between_two_chunks_the_tool_is_off_and_the_machine_rests()
    {
        await using var bench = new SimulatedBench(programLines: 130);
        var links = new List<Links.WithheldLink>();
        await using var session = await bench.OpenAsync(opened: links.Add);
        var states = new List<(bool Moving, int Outputs, int Threads)>();
        links[0].Sending = line =>
        {
            var now = bench.Controller.Status;
            if (line.StartsWith("DL\r", StringComparison.Ordinal)) states.Add((now.IsMoving || now.IsSequenceOpen, now.Outputs, now.RunningThreads));
        };

        await JobRunner.RunAsync(Strokes(60), session, Job, null, CancellationToken.None);

        Assert.True(states.Count > 4);
        Assert.All(states, state => Assert.Equal((false, 0, 0), state));
    }

    [Fact]
    public async Task A_line_that_fails_in_the_program_names_the_line_its_text_and_its_entity()
    {
        await using var bench = new SimulatedBench();
        var result = await bench.RunAsync(MotionPrograms.ArcChain(3, 5), Job);

        Assert.Equal((JobOutcome.Refused, TcCode.NumberOutOfRange, 0, 1), (result.Outcome, (TcCode?)result.Refusal?.Code, result.SegmentsExecuted, result.Rejected));
        Assert.Matches("line [0-9]+ of the downloaded program", result.Message);
        Assert.Contains("'CR 5,180,-180;CR 5,180,180;CR 5,180,-180'", result.Message, StringComparison.Ordinal);
        Assert.EndsWith("Drawing entity 0.", result.Message, StringComparison.Ordinal);
        Assert.Equal((0, 0), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads));
    }

    [Fact]
    public async Task What_was_cut_before_a_failing_line_is_counted()
    {
        await using var bench = new SimulatedBench();
        var strokes = Strokes(2).Strokes;
        var bad = new MotionStroke(2, new(0, 9000), [new VectorSequence(new(0, 9000), 20000, [MotionPrograms.Line(0, 9000, 77, 1)])]);
        var result = await bench.RunAsync(new MotionProgram(MachineProfile.Default, default, [.. strokes, bad]), Job);

        Assert.Equal((JobOutcome.Refused, 4), (result.Outcome, result.SegmentsExecuted));
        Assert.Equal([2, 2, 0], result.ExecutedByStroke);
        Assert.EndsWith("Drawing entity 77.", result.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_limit_switch_in_the_middle_names_the_entity_and_no_later_stroke_is_begun()
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.LongLine(200000);
        program = program with { Strokes = [.. program.Strokes, new MotionStroke(1, new(0, 5000), [new VectorSequence(new(0, 5000), 20000, [MotionPrograms.Line(0, 9000, 8, 4000)])])] };
        var hit = new CancelWhen(progress => progress.X > 50000, () => bench.Controller.SetLimitSwitch(0, forward: true, active: true));
        var result = await bench.RunAsync(program, Job, hit);

        Assert.Equal((JobOutcome.Refused, 0), (result.Outcome, result.SegmentsExecuted));
        Assert.Contains("forward limit switch", result.Message, StringComparison.Ordinal);
        Assert.EndsWith("Drawing entity 0.", result.Message, StringComparison.Ordinal);
        Assert.All(bench.Controller.Record.Snapshot(), sample => Assert.Equal(0, sample.B));
    }

    [Fact]
    public async Task A_limit_switch_while_the_program_still_feeds_does_not_leave_it_waiting_for_room()
    {
        await using var bench = new SimulatedBench();
        var hit = new CancelWhen(progress => progress.X > 6000, () => bench.Controller.SetLimitSwitch(0, forward: true, active: true));
        var result = await bench.RunAsync(MotionPrograms.ShortLines(3000), Job, hit);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.InRange(result.SegmentsExecuted, (bench.Last.A / 60) - 1, (bench.Last.A / 60) + 1);
    }

    [Fact]
    public async Task A_stop_in_the_second_chunk_counts_both()
    {
        await using var bench = new SimulatedBench(programLines: 130);
        using var stop = new CancellationTokenSource();
        var result = await bench.RunAsync(MotionPrograms.ShortLines(1600), Job, new CancelWhen(progress => progress.X > 60000, stop.Cancel), stop.Token);

        Assert.Equal(JobOutcome.Stopped, result.Outcome);
        Assert.InRange(result.SegmentsExecuted, (bench.Last.A / 60) - 1, (bench.Last.A / 60) + 1);
    }

    [Fact]
    public async Task A_stop_while_the_tool_settles_keeps_the_cut_from_beginning()
    {
        await using var bench = new SimulatedBench(clock: new ManualTimeProvider());
        using var stop = new CancellationTokenSource();
        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), Job, new CancelWhen(progress => progress.ToolOn, stop.Cancel), stop.Token);

        Assert.Equal((JobOutcome.Stopped, 0), (result.Outcome, result.SegmentsExecuted));
        Assert.Equal((1000, 0, 0), (bench.Last.A, bench.Last.B, bench.Last.Outputs));
    }

    [Fact]
    public async Task A_stop_reaches_the_program_even_while_the_host_waits_for_a_reply()
    {
        await using var bench = new SimulatedBench(clock: new ManualTimeProvider());
        var links = new List<Links.WithheldLink>();
        await using var session = await bench.OpenAsync(opened: links.Add);
        using var stop = new CancellationTokenSource();
        var running = JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, Job, new CancelWhen(progress => progress.ToolOn, links[0].Withhold), stop.Token);
        await links[0].HasWaiter;

        await stop.CancelAsync();
        var atOnce = bench.Controller.Status.Outputs;
        bench.Controller.Advance(TimeSpan.FromSeconds(0.5)); // longer than the settle time: the program would have started the cut
        while (!running.IsCompleted)
        {
            bench.Controller.Advance(TimeSpan.FromSeconds(1));
            await Task.Yield();
        }

        Assert.Equal(0, atOnce);
        Assert.Equal((1000, 0, 0), (bench.Last.A, bench.Last.B, bench.Last.Outputs));
    }

    [Fact]
    public async Task What_a_run_killed_in_a_chunk_had_found_is_given_back_by_the_next_one()
    {
        await using var bench = new SimulatedBench(programLines: 130);
        await bench.DownloadAsync("#OWNER\nEN");
        var folder = Directory.CreateTempSubdirectory();
        var options = Job with { JournalPath = Path.Combine(folder.FullName, "job.jsonl") };
        await bench.RunAsync(MotionPrograms.ShortLines(1600), options, new CancelWhen(progress => progress.X > 60000, bench.Controller.DropConnections));
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));

        await bench.RunAsync(MotionPrograms.Paper, options);

        Assert.EndsWith(new Accepted("#OWNER\nEN").ToString(), await bench.FingerprintAsync(), StringComparison.Ordinal);
        folder.Delete(recursive: true);
    }

    [Fact]
    public async Task Progress_never_goes_back_and_tells_the_tool_as_the_controller_has_it()
    {
        await using var bench = new SimulatedBench(programLines: 130);
        var reports = new List<JobProgress>();
        await bench.RunAsync(Strokes(20), Job, new CancelWhen(progress =>
        {
            reports.Add(progress);
            return false;
        }, () => { }));

        Assert.Equal(reports.Select(report => report.SegmentsExecuted).Order(), reports.Select(report => report.SegmentsExecuted));
        Assert.True(reports.Select(report => report.SegmentsExecuted).Distinct().Count() > 20);
        Assert.Contains(reports, report => report.ToolOn);
        Assert.Contains(reports, report => !report.ToolOn);
    }

    [Fact]
    public async Task The_generators_own_program_runs_the_same()
    {
        await using var bench = new SimulatedBench();
        var program = MotionProgramGenerator.Generate(Toolpaths.Paper, MachineProfile.Default, new(0.001, 0.0), null).Program!;
        var result = await bench.RunAsync(program, Job);

        Assert.Equal((JobOutcome.Complete, program.SegmentCount), (result.Outcome, result.SegmentsExecuted));
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    [Fact]
    public async Task Where_the_controller_cannot_count_to_the_drawing_nothing_is_begun()
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("DPA=2147483000");
        var result = await bench.RunAsync(MotionPrograms.Paper, Job);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("beyond the position range of the controller", result.Message, StringComparison.Ordinal);
    }

    /// <summary>Strokes of two sequences side by side, one entity each.</summary>
    private static MotionProgram Strokes(int count) => new(MachineProfile.Default, default, [.. Enumerable.Range(0, count).Select(Stroke)]);

    private static MotionStroke Stroke(int i)
    {
        CountsPoint start = new(0, i * 100), corner = new(200, i * 100), end = new(200, (i * 100) + 50);
        return new MotionStroke(i, start,
        [
            new VectorSequence(start, 20000, [MotionPrograms.Line(corner.X, corner.Y, i, 200)]),
            new VectorSequence(corner, 20000, [MotionPrograms.Line(end.X, end.Y, i, 50)]),
        ]);
    }

    private static async Task<(JobResult Result, int Downloads)> CountedAsync(SimulatedBench bench, MotionProgram program)
    {
        var links = new List<Links.WithheldLink>();
        await using var session = await bench.OpenAsync(opened: links.Add);
        var downloads = 0;
        links[0].Sending = line => downloads += line.StartsWith("DL\r", StringComparison.Ordinal) ? 1 : 0;
        return (await JobRunner.RunAsync(program, session, Job, null, CancellationToken.None), downloads);
    }
}
