using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Tests.Documents;

public class JobPreparationTests
{
    [Fact]
    public void Layers_that_are_off_frozen_or_not_plotted_are_not_cut_and_can_be_named_all_the_same()
    {
        var drawing = Open("nameplate");
        var usual = JobPreparation.Analyse(drawing, new DrawingSettings());
        var named = JobPreparation.Analyse(drawing, new DrawingSettings { Layers = ["mittellinien"] });
        var skipped = JobPreparation.Analyse(drawing, new DrawingSettings { SkippedLayers = ["Rahmen"] });

        Assert.Equal(2, named.Count);
        Assert.True(skipped.Count < usual.Count);
    }

    [Fact]
    public void An_unknown_layer_and_an_unknown_handle_are_named()
    {
        var drawing = Open("nameplate");
        var layer = Assert.Throws<SettingException>(() => JobPreparation.Analyse(drawing, new DrawingSettings { SkippedLayers = ["Frame"] }));
        var handle = Assert.Throws<SettingException>(() => StageOptions.SequencingFor(drawing, new DrawingSettings { Enter = new ContourEntry.ByHandle("FFFF") }));

        Assert.Contains("'Frame'", layer.Message, StringComparison.Ordinal);
        Assert.Contains("FFFF", handle.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_entering_entity_comes_first()
    {
        var drawing = Open("paper-001");
        var handle = drawing.SourceOf(2).Handle!;
        var job = JobPreparation.Prepare(drawing, new DrawingSettings { Enter = new ContourEntry.ByHandle(handle) }, MotionStyle.Continuous);

        Assert.Equal(2, job.Toolpath.Strokes[0].Moves[0].EntityIndex);
    }

    [Fact]
    public void Inches_are_cut_in_their_true_size()
    {
        var drawing = Open("gasket");
        var job = JobPreparation.Prepare(drawing, new DrawingSettings(), MotionStyle.Continuous);
        var box = job.Toolpath.Strokes.SelectMany(stroke => stroke.Moves).Aggregate(Bounds2D.Empty, (all, move) => all.Union(move.Segment.Bounds));

        Assert.InRange(box.Width, 60.0, 200.0);
    }

    [Fact]
    public void A_missing_file_is_a_drawing_with_one_error()
    {
        var drawing = Open("nowhere");

        Assert.Equal("DOC0001", Assert.Single(drawing.Diagnostics).Id);
        Assert.True(drawing.HasErrors);
    }

    private static Engraver.Core.Drawings.Drawing Open(string sample) =>
        DrawingFile.Open(Path.Combine(RepositoryFolder.Samples, sample + ".dxf"), new DrawingSettings(), CancellationToken.None);
}
