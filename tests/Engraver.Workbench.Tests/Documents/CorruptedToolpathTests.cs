using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;
using Engraver.Workbench.Tests.Machines;

namespace Engraver.Workbench.Tests.Documents;

/// <summary>A toolpath that differs from the drawing gives no program, so that it cannot be run, posted or armed even with accepted errors; correct drawings
/// are not refused.</summary>
public class CorruptedToolpathTests
{
    private static readonly DrawingSettings s_settings = new();

    public static TheoryData<string> Spoilers => ["moved", "left out", "extra"];

    [Theory]
    [MemberData(nameof(Spoilers))]
    public void A_spoiled_toolpath_is_refused_by_name(string how)
    {
        foreach (var entity in new[] { 0, 1 })
        {
            var job = Corrupted(how, entity);

            Assert.Null(job.Motion.Program);
            Assert.All(job.Faults, fault => Assert.Equal((Severity.Error, job.Drawing.SourceOf(entity)), (fault.Severity, fault.Source)));
            Assert.Contains(job.Faults[0], job.Diagnostics);
        }
    }

    [Theory]
    [MemberData(nameof(Spoilers))]
    public void It_is_not_posted_and_not_armed_even_when_errors_are_accepted(string how)
    {
        var job = Corrupted(how, 0);
        var posted = PostedProgram.FromJob(job, PostTable.Find("galil").Post, PostedProgram.NoOptions);
        var ready = new MachineStatus { State = MachineState.Ready, Link = "x", MotorsOn = true };
        var checklist = ArmingChecklist.Create(job, ready, errorsAccepted: true, MachineBench.Placed, default);

        Assert.Null(posted.Text);
        Assert.Contains(job.Faults[0].Id, posted.NoProgramReason, StringComparison.Ordinal);
        Assert.Contains(job.Faults[0], posted.Diagnostics);
        Assert.False(checklist.Passed);
        Assert.Contains(checklist.Checks, check => !check.Passed && check.Message.Contains(job.Faults[0].Id, StringComparison.Ordinal));
        Assert.True(ArmingChecklist.Create(MachineBench.Job(), ready, errorsAccepted: false, MachineBench.Placed, default).Passed);
    }

    [Fact]
    public void A_sequence_that_lost_a_stroke_is_not_written_as_drawing()
    {
        var ordered = JobPreparation.To<OrderedJob>(Drawing(), s_settings);

        Assert.NotNull(PostedProgram.FromSequence(ordered, PostTable.Find("cldata").Post, PostedProgram.NoOptions).Text);
        var lost = PostedProgram.FromSequence(ordered with { Sequence = ordered.Sequence with { Strokes = [.. ordered.Sequence.Strokes.Skip(1)] } }, PostTable.Find("cldata").Post, PostedProgram.NoOptions);
        Assert.Null(lost.Text);
        Assert.Contains(lost.Diagnostics, finding => finding.Id == "VER0021");
        Assert.Equal("The toolpath deviates from the drawing (VER0021)", lost.NoProgramReason);
    }

    [Fact]
    public void Every_sample_passes_in_every_setting()
    {
        foreach (var file in Directory.GetFiles(RepositoryFolder.Samples, "*.dxf"))
        {
            foreach (var settings in new[] { s_settings, s_settings with { RecoverArcs = true, MaxErrorMm = 0.02 }, s_settings with { KeepDuplicates = true }, s_settings with { JoinToleranceMm = 0.5 } }) AssertPasses(file, settings);
        }
    }

    [CorpusFact]
    public void Drawings_of_the_corpus_pass()
    {
        var files = Directory.GetFiles(Path.Combine(RepositoryFolder.Corpus!, "files"), "*.dxf", SearchOption.AllDirectories).Where(file => new FileInfo(file).Length < 300_000).Order(StringComparer.Ordinal).ToArray();
        Assert.InRange(files.Length, 100, 400);
        var step = TestExtent.IsFull ? 1 : 3; // The fast subset tests every third.
        foreach (var file in files.Where((_, i) => i % step == 0)) AssertPasses(file, s_settings);
    }

    private static void AssertPasses(string file, DrawingSettings settings)
    {
        var job = JobPreparation.Prepare(DrawingFile.Open(file, settings, CancellationToken.None), settings, MotionStyle.Continuous);
        Assert.True(job.Faults.Count == 0, $"{file}: {string.Join(' ', job.Faults.Take(3).Select(fault => fault.Sentence))}");
    }

    private static PreparedJob Corrupted(string how, int entity)
    {
        var path = JobPreparation.To<PathJob>(Drawing(), s_settings);
        DrawnJob spoiled = path with { Toolpath = Corrupt(path.Toolpath, how, entity) };
        foreach (var stage in JobStages.To<CheckedJob>().Skip(JobStages.To<PathJob>().Count())) spoiled = stage.Run(spoiled, CancellationToken.None);
        return PreparedJob.From((CheckedJob)spoiled);
    }

    private static Toolpath Corrupt(Toolpath path, string how, int entity)
    {
        var stroke = path.Strokes.Single(stroke => stroke.Moves.Any(move => move.EntityIndex == entity));
        IReadOnlyList<StrokeMove> moves = how switch
        {
            "moved" => [.. stroke.Moves.Select(move => move with { Segment = Moved(move.Segment) })],
            "left out" => [.. stroke.Moves.Skip(1)],
            _ => [.. stroke.Moves, new StrokeMove(Segment.FromLine(stroke.End, stroke.End + new Vector2D(1, 1)), entity)],
        };
        return path with { Strokes = [.. path.Strokes.Select(other => other == stroke ? stroke with { Moves = moves } : other).Where(other => other.Moves.Count > 0)] };
    }

    private static Segment Moved(Segment segment)
    {
        var by = new Vector2D(0.003, 0.004);
        return segment.Kind == SegmentKind.Line ? Segment.FromLine(segment.Start + by, segment.End + by) : Segment.FromArc(segment.Arc with { Centre = segment.Arc.Centre + by }, segment.Start + by, segment.End + by);
    }

    private static Drawing Drawing() =>
        new DrawingBuilder().Line(0, 0, 20, 0).Free(FreeCurves.Spline(3, [new(100, 0), new(110, 20), new(120, -20), new(130, 0)], [1, 1, 1, 1])).Build();
}
