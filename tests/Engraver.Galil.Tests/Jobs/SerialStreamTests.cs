using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>How full a serial line is while segments are streamed, and what a line of several segments changes for stops and refusals.</summary>
public class SerialStreamTests
{
    private const string Heartbeat = "hb=20;";
    private const double MostLineSeconds = 0.02;

    [Theory]
    [InlineData(1200)]
    [InlineData(9600)]
    [InlineData(19200)]
    [InlineData(38400)]
    [InlineData(115200)]
    public async Task A_line_has_as_many_segments_as_eighty_characters_and_twenty_milliseconds_allow(int baud)
    {
        var lines = await StreamAsync(baud, 700, baud == 1200 ? 8000 : 400);
        var line = new SerialLine(baud);

        var segments = lines.Where(sent => sent.Text.Contains("VP ", StringComparison.Ordinal)).Select(sent => sent.Text).ToList();
        Assert.Equal(700, segments.Sum(Count));
        Assert.All(segments, text => Assert.True(!text.Contains(';', StringComparison.Ordinal) || (text.Length <= 81 && line.Time(text.Length).TotalSeconds <= MostLineSeconds), text));
        var average = lines.TakeWhile(sent => sent.Text != "BGS\r").Select(sent => Count(sent.Text)).Where(count => count > 0).Average();
        Assert.True(baud switch { 1200 => average == 1.0, 9600 => average < 1.1, 19200 => average > 1.9, 38400 => average > 4.0, _ => average > 5.0 }, $"{average}");
    }

    /// <summary>Compared with a sender that has one line outstanding and neither polls nor sends heartbeats. The path needs a little more than
    /// the line carries: after the beginning the buffer is neither full nor empty. At 115,200 baud it lasts half a second,
    /// so that the counter is read more often.</summary>
    [Theory]
    [InlineData(19200, 118, 0.95)]
    [InlineData(115200, 20, 0.925)]
    public async Task The_wire_is_kept_full(int baud, int step, double share)
    {
        var lines = await StreamAsync(baud, 2200, step);
        var line = new SerialLine(baud);
        var begun = lines.FindIndex(sent => sent.Text == "BGS\r");
        foreach (var (phase, least) in new[] { (lines[..begun], 0.98), (lines[(begun + ((lines.Count - begun) / 3))..], share) })
        {
            var (first, last) = (phase.FindIndex(sent => Count(sent.Text) > 0), phase.FindLastIndex(sent => Count(sent.Text) > 0));
            var ideal = phase[first..last].Where(sent => Count(sent.Text) > 0).Sum(sent => line.Time(sent.Text.Replace(Heartbeat, "", StringComparison.Ordinal).Length + Count(sent.Text)).TotalSeconds);
            var took = (phase[last].At - phase[first].At).TotalSeconds;

            Assert.True(ideal >= least * took, $"{ideal / took:0.000} of the throughput, {phase[first..last].Sum(sent => Count(sent.Text)) / took:0.0} segments/s");
        }
    }

    [Theory]
    [InlineData(19200, 400)]
    [InlineData(115200, 60)]
    public async Task A_stop_while_lines_are_sent_ends_at_rest_with_the_tool_off_and_no_segment_after_it(int baud, int step)
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();
        var (pressedAt, sent) = (0L, new List<string>());
        var press = new CancelWhen(progress => progress.X > 100 * step, () =>
        {
            pressedAt = bench.Controller.Status.Sample;
            sent.Clear();
            stop.Cancel();
        });

        var result = await bench.RunSerialAsync(baud, MotionPrograms.ShortLines(2000, step), JobMode.Stream, press, sent.Add, stop.Token);

        Assert.Equal(JobOutcome.Stopped, result.Outcome);
        CutRecord.AssertSafeAfter(bench, pressedAt, toolSeconds: 0.15, restSeconds: 0.6);
        Assert.DoesNotContain(sent, text => Count(text) > 0);
    }

    /// <summary>The buffer is full for most of the time: no line has more segments than there are free places.</summary>
    [Theory]
    [InlineData(19200)]
    [InlineData(115200)]
    public async Task A_full_buffer_refuses_nothing(int baud)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.ShortLines(900, 500);

        var result = await bench.RunSerialAsync(baud, program, JobMode.Stream);

        Assert.Equal((JobOutcome.Complete, 900, 900, 0), (result.Outcome, result.SegmentsExecuted, result.SegmentsSent, result.Rejected));
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    /// <summary>The controller refuses the third segment of a line; the host does not see the changed byte.</summary>
    [Fact]
    public async Task A_segment_refused_within_a_line_ends_the_job_with_its_entity_and_counts_those_before_it()
    {
        await using var bench = new SimulatedBench(clock: new ManualTimeProvider());
        await using var session = await bench.OpenSerialAsync(
            115200, harm: text => text.Replace("VP 6000,", "VX 6000,", StringComparison.Ordinal), mend: text => text.Replace("VX 6000,", "VP 6000,", StringComparison.Ordinal));

        var result = await JobRunner.RunAsync(MotionPrograms.ShortLines(700, 500), session, SimulatedBench.Job with { Strategy = JobMode.Stream.Strategy() }, null, CancellationToken.None);

        Assert.Equal((JobOutcome.Refused, 11, 1), (result.Outcome, result.SegmentsSent, result.Rejected));
        Assert.Contains("VP 6000,0", result.Message, StringComparison.Ordinal);
        Assert.Contains("11", result.Message, StringComparison.Ordinal);
    }

    private static int Count(string line) => line.Split("VP ").Length - 1;

    private static async Task<List<(TimeSpan At, string Text)>> StreamAsync(int baud, int count, int step)
    {
        await using var bench = new SimulatedBench(clock: new ManualTimeProvider()); // only bytes advance the time
        var lines = new List<(TimeSpan At, string Text)>();
        var start = bench.Clock.GetTimestamp();
        var result = await bench.RunSerialAsync(baud, MotionPrograms.ShortLines(count, step), JobMode.Stream, sending: text => lines.Add((bench.Clock.GetElapsedTime(start), text)));

        Assert.Equal((JobOutcome.Complete, count, 0, ""), (result.Outcome, result.SegmentsExecuted, result.Underruns, result.Outcome == JobOutcome.Complete ? "" : result.Message));
        return lines;
    }
}
