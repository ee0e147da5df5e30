using Engraver.Galil.Jobs;
using Engraver.Galil.Programs;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Tests.Jobs;

public class JobRunnerTests
{
    public static TheoryData<JobMode> Modes => [JobMode.Stream, JobMode.Calls];

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task The_papers_drawing_ends_on_its_counts_with_the_tool_off(JobMode mode)
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job with { Mode = mode });

        Assert.Equal("Done: 4 segments.", result.Sentence);
        Assert.Equal((JobOutcome.Complete, 4, 4, 0, 0), (result.Outcome, result.SegmentsSent, result.SegmentsExecuted, result.Underruns, result.Rejected));
        Assert.Equal(new CountsPoint(5000, 5000), result.FinalPosition);
        Assert.Equal((5000, 5000, 0), (bench.Last.A, bench.Last.B, bench.Last.Outputs));
        Assert.Equal([0, 1, 2, 3], result.ExecutedEntityIndices);
        AssertCutOnPath(bench, MotionPrograms.Paper);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task Over_TCP_the_same_bytes_do_the_same(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenTcpAsync();

        var result = await JobRunner.RunAsync(MotionPrograms.Paper, session, SimulatedBench.Job with { Mode = mode }, null, CancellationToken.None);

        Assert.Equal((JobOutcome.Complete, 4, 0), (result.Outcome, result.SegmentsExecuted, result.Underruns));
        Assert.Equal((5000, 5000, 0), (bench.Last.A, bench.Last.B, bench.Last.Outputs));
        AssertCutOnPath(bench, MotionPrograms.Paper);
    }

    [Fact]
    public async Task A_sequence_longer_than_the_buffer_is_fed_without_running_dry()
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.ShortLines(1600);

        var result = await bench.RunAsync(program, SimulatedBench.Job);

        Assert.Equal("Done: 1600 segments.", result.Sentence);
        Assert.Equal((JobOutcome.Complete, 1600, 1600, 0, 0), (result.Outcome, result.SegmentsSent, result.SegmentsExecuted, result.Underruns, result.Rejected));
        Assert.Equal(new CountsPoint(96000, 0), result.FinalPosition);
        Assert.Equal(0, bench.Controller.Status.Underruns);
        AssertCutOnPath(bench, program);
    }

    /// <summary>Every sample with the tool on lies within a count of the drawing, and the whole path was passed with the tool on.</summary>
    private static void AssertCutOnPath(SimulatedBench bench, MotionProgram program)
    {
        var path = new EngravedPath(program);
        var cutting = bench.Controller.Record.Snapshot().Where(sample => sample.Outputs == 1).ToList();
        Assert.All(cutting, sample => Assert.InRange(path.DistanceTo(sample.A, sample.B), 0, 1.0));
        var length = cutting.Zip(cutting.Skip(1)).Sum(pair => Math.Sqrt(Math.Pow(pair.Second.A - pair.First.A, 2) + Math.Pow(pair.Second.B - pair.First.B, 2)));
        Assert.InRange(length, 0.99 * program.Strokes.Sum(stroke => stroke.Sequences.Sum(sequence => sequence.Length)), double.MaxValue);
    }
}
