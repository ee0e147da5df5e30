using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.Properties;
using Engraver.Core.Machines;
using Engraver.TestKit;

namespace Engraver.App.Tests.Lettering;

[Collection(DesktopCollection.Name)]
public sealed class CutTextTests(DesktopFixture fixture)
{
    /// <summary>A line, and two texts: entities 1 and 2 of the shown drawing.</summary>
    private static readonly (int, object)[] s_entities =
    [
        (0, "LINE"), (8, "0"), (5, "A1"), (10, 0.0), (20, 0.0), (11, 40.0), (21, 0.0),
        (0, "TEXT"), (8, "0"), (5, "A2"), (10, 0.0), (20, 5.0), (40, 5.0), (1, "LH"),
        (0, "TEXT"), (8, "0"), (5, "A3"), (10, 20.0), (20, 5.0), (40, 5.0), (1, "T"),
    ];

    [Fact]
    public Task A_text_is_highlighted_while_it_is_played_and_cut() => fixture.WithOperator(here =>
    {
        here.Open(Write());
        here.Enter("CNCCUT", "32");
        here.WaitUntilIdle();
        Assert.Equal((1, 3), (here.Window.Canvas.Scene!.Drawing.Entities.Count, here.Window.Canvas.Scene.Shown.Entities.Count));
        Assert.Contains(here.Desk.Derived.Job!.Sequence.Strokes, stroke => stroke.Moves.Count > 0);

        var played = new SortedSet<int>();
        for (var part = 0.0; part <= 1.0; part += 0.01)
        {
            here.Window.Model.Playback.At = here.Window.Model.Playback.Total * part;
            here.Step();
            if (here.Window.Canvas.Highlight is { } entity) played.Add(entity);
        }

        Assert.Equal([0, 1, 2], played);
        here.Show("Plots");
        here.Step();
        here.Enter("CNCCONNECT", "sim:?speed=5", "CNCARM", "Stream");
        var cut = new SortedSet<int>();
        here.Hands.Type("CNCRUN");
        here.Hands.Press(Key.Enter);
        here.Until(() =>
        {
            if (here.Commands.Machine.IsRunning && here.Window.Canvas.Highlight is { } entity) cut.Add(entity);
            return here.Commands.Machine.Runs.LastRun is not null && !here.Commands.Machine.IsRunning;
        });
        here.WaitUntilIdle();

        Assert.Equal(JobOutcome.Complete, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        Assert.Equal(here.Window.Canvas.Overlay!.MoveCount, here.Window.Canvas.EngravedMoves);
        Assert.True(cut.Max > 0, string.Join(", ", cut));
    });

    [Fact]
    public Task A_selected_text_is_shown_in_the_palettes() => fixture.WithOperator(here =>
    {
        here.Open(Write());
        here.Enter("SELECT", "Handle", "A2", "");
        here.Show("Properties");
        here.WaitUntilIdle();

        Assert.Equal([1], here.Commands.Document.Current.Selection);
        Assert.Contains(((PropertiesModel)here.Window.GetVisualDescendants().OfType<PropertiesView>().First().DataContext!).Lines, line => line.Value == "TEXT");
        here.Enter("LIST");
        Assert.Contains(here.History, line => line.Contains("TEXT, handle A2", StringComparison.Ordinal));
    });

    private static string Write()
    {
        var file = Path.Combine(Directory.CreateTempSubdirectory("engraver-texts-").FullName, "texts.dxf");
        File.WriteAllBytes(file, DxfText.WithEntities(s_entities).ToAscii());
        return file;
    }
}
