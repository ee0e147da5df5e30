using Engraver.App.Jobs;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Settings;

namespace Engraver.App.Tests.Lettering;

[Collection(DesktopCollection.Name)]
public sealed class NextPlateTests(DesktopFixture fixture)
{
    /// <summary>The letters on the canvas are those of the number, also after the plate before it was engraved.</summary>
    [Fact]
    public Task The_canvas_shows_the_number_that_is_engraved_next() => fixture.WithOperator(here =>
    {
        here.Open(Write("[[n:0;start=7]]"));
        here.WaitUntilIdle();
        var asWritten = PartsOf(here);
        here.Enter("CNCTEXT", "Yes");
        here.WaitUntilIdle();
        var seven = PartsOf(here);
        Assert.NotEqual(asWritten.Count, seven.Count);
        Assert.Equal(PartsOf(Drawing("7")), seven);
        Assert.Contains(new JobModel(here.Desk).Figures, line => line.Value == "Plate 1: n=7");

        here.Enter("CNCCONNECT", "sim:?speed=max", "CNCARM", "Stream", "CNCRUN");
        here.Until(() => here.Commands.Machine.Runs.LastRun is not null && !here.Commands.Machine.IsRunning);
        here.WaitUntilIdle();

        Assert.Equal(PartsOf(Drawing("8")), PartsOf(here));
        Assert.Contains(new JobModel(here.Desk).Figures, line => line.Value == "Plate 2: n=8");
        Assert.Equal("n=8", here.Desk.Derived.Job!.Plate!.ToString());
    });

    private static List<Segment> PartsOf(Operator here) => PartsOf(here.Window.Canvas.Scene!.Shown);

    private static List<Segment> PartsOf(Drawing shown) => [.. Enumerable.Range(0, shown.Parts.Count).Select(part => shown.SegmentOf(shown.Parts[part]))];

    private static Drawing Drawing(string text) => ShownDrawing.Of(DrawingFile.Open(Write(text), new DrawingSettings(), CancellationToken.None));

    private static string Write(string text)
    {
        var file = Path.Combine(Directory.CreateTempSubdirectory("engraver-plates-").FullName, "plate.dxf");
        File.WriteAllBytes(file, DxfText.WithEntities((0, "TEXT"), (8, "0"), (5, "A2"), (10, 0.0), (20, 5.0), (40, 5.0), (1, text)).ToAscii());
        return file;
    }
}
