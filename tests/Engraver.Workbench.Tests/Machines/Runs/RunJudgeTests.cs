using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Links;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines.Runs;

/// <summary>A correct record passes the judge, a corrupted one does not.</summary>
public class RunJudgeTests
{
    [Fact]
    public async Task A_faithful_record_is_within_the_tolerance_and_whole()
    {
        var (job, record) = await RecordedAsync("nameplate");
        var verdict = RecordJudgement.Of(job, record, 0, 0);

        Assert.InRange(verdict.MaxDeviationMm!.Value, 0.0, 0.0035);
        Assert.Equal(0.0, verdict.MissingLengthMm);
    }

    [Fact]
    public async Task One_sample_moved_by_five_counts_is_noticed()
    {
        var (job, record) = await RecordedAsync("paper-001");
        var spoiled = record.ToArray();
        var at = Array.FindIndex(spoiled, row => (row.Outputs & 1) != 0 && row is { B: 50000, A: > 90000 }); // on the lower line, far from its ends
        spoiled[at] = spoiled[at] with { B = spoiled[at].B + 5 };

        Assert.Equal(0.005, RecordJudgement.Of(job, spoiled, 0, 0).MaxDeviationMm!.Value, precision: 6);
    }

    [Fact]
    public async Task One_stroke_left_out_is_missing_with_its_length()
    {
        var (job, record) = await RecordedAsync("nameplate");
        var stroke = job.Toolpath.Strokes.MinBy(s => s.Length)!;
        var box = stroke.Moves.Select(move => move.Segment.Bounds).Aggregate((a, b) => a.Union(b)).Grown(0.002);
        var spoiled = record.Select(row => box.Contains(new Engraver.Core.Geometry.Point2D(row.A / 1000.0, row.B / 1000.0)) ? row with { Outputs = 0 } : row).ToArray();

        Assert.InRange(RecordJudgement.Of(job, spoiled, 0, 0).MissingLengthMm!.Value, 0.95 * stroke.Length, 1.05 * stroke.Length);
    }

    /// <summary>The controller continues with its buffer until its watchdog trips: that part is not missing, and its length is unknown.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task After_a_lost_link_nobody_says_how_much_is_missing(JobMode mode)
    {
        var (job, report) = await LostAsync(mode);

        Assert.Equal((JobOutcome.LinkLost, null), (report.Result.Outcome, report.Judgement.MissingLengthMm));
        Assert.NotNull(report.Judgement.MaxDeviationMm);
        Assert.Contains("the length that was not cut is unknown", RunText.Sentence(job, report, text => text), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0.0, "the whole drawing was cut")]
    [InlineData(0.0004, "less than 0.001 mm of the drawing was not cut")]
    [InlineData(0.0006, "less than 0.001 mm of the drawing was not cut")]
    [InlineData(0.002, "0.002 mm of the drawing were NOT CUT")]
    public async Task A_length_that_is_missing_is_never_told_as_none(double missing, string said)
    {
        var (job, report) = await LostAsync(JobMode.Stream);
        var sentence = RunText.Sentence(job, report with { Judgement = report.Judgement with { MissingLengthMm = missing } }, text => text);

        Assert.Contains(said, sentence, StringComparison.Ordinal);
        Assert.DoesNotContain(" 0 mm of the drawing", sentence, StringComparison.Ordinal);
    }

    private static async Task<(PreparedJob Job, MachineRunReport Report)> LostAsync(JobMode mode)
    {
        var journal = Path.GetTempFileName();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Time = new ManualTimeProvider() });
        var isCut = false;
        await using var connection = MachineConnection.FromLink("memory", _ => Task.FromResult<IControllerLink>(new BreakingLink(new StreamLink(controller.OpenConnection(), "memory"), () => isCut)), () => MachineClock.FromSimulator(controller.JoinClock()));
        var job = JobPreparation.Prepare(new DrawingBuilder().Line(0, 0, 100, 0).Build(), new DrawingSettings(), mode.Strategy().Style);
        var options = new MachineRunOptions(new TcpAddress("memory", 1), mode.Strategy()) { JournalPath = journal };

        var report = await MachineRun.RunAsync(job, job.Motion.Program!, connection, options, TimeProvider.System, new JobListener(progress => isCut |= progress.X > 20000), CancellationToken.None);
        File.Delete(journal);
        return (job, report);
    }

    private sealed class BreakingLink(IControllerLink inner, Func<bool> isCut) : IControllerLink
    {
        public string Description => inner.Description;

        public SerialLine? Line => inner.Line;

        public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation) => isCut() ? throw new IOException("cut") : inner.WriteAsync(bytes, cancellation);

        public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => inner.ReadAsync(buffer, cancellation);

        public ValueTask DisposeAsync() => inner.DisposeAsync();
    }

    [Fact]
    public async Task A_rapid_with_the_tool_on_is_noticed()
    {
        var (job, record) = await RecordedAsync("paper-001");
        var spoiled = record.Select(row => row with { Outputs = 1 }).ToArray();

        Assert.True(RecordJudgement.Of(job, spoiled, 0, 0).MaxDeviationMm > 1.0);
    }

    [Fact]
    public async Task A_record_in_another_frame_is_off_by_the_frame()
    {
        var (job, record) = await RecordedAsync("paper-001");

        Assert.InRange(RecordJudgement.Of(job, record, 7, 0).MaxDeviationMm!.Value, 0.0055, 0.0105);
    }

    [Fact]
    public async Task Without_a_cutting_sample_nothing_is_known_of_the_deviation_and_all_is_missing()
    {
        var (job, _) = await RecordedAsync("paper-001");
        var verdict = RecordJudgement.Of(job, [], 0, 0);

        Assert.Null(verdict.MaxDeviationMm);
        Assert.Equal(job.Sequence.PathLength, verdict.MissingLengthMm!.Value, precision: 9);
    }

    private static async Task<(PreparedJob Job, IReadOnlyList<MotionSample> Record)> RecordedAsync(string sample)
    {
        var settings = new DrawingSettings();
        var drawing = DrawingFile.Open(Path.Combine(RepositoryFolder.Samples, sample + ".dxf"), new DrawingSettings(), CancellationToken.None);
        var job = JobPreparation.Prepare(drawing, settings, MotionStyle.Continuous);
        await using var connection = MachineConnection.To(new SimulatedAddress(double.PositiveInfinity), TimeProvider.System, keepsRecord: true);
        using var clock = connection.CreateClock();
        await using var session = await Galil.Sessions.ControllerSession.OpenAsync(connection.OpenLinkAsync, new(), clock.Time, CancellationToken.None);
        var result = await JobRunner.RunAsync(job.Motion.Program!, session, new JobOptions(), progress: null, CancellationToken.None);
        Assert.Equal(JobOutcome.Complete, result.Outcome);
        return (job, connection.Simulator!.Record.Snapshot());
    }
}
