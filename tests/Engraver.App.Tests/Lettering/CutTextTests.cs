using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.Properties;
using Engraver.Core.Drawings;
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
        Assert.NotEqual(0, here.Window.Canvas.Overlay.Recorded.Count);
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

    [Fact]
    public Task Texts_that_are_not_cut_are_offered_once() => fixture.WithOperator(here =>
    {
        here.Open(Write());
        here.WaitUntilIdle();
        Assert.True(here.Find<Button>("TextOfferYes").IsEffectivelyVisible);
        Assert.Equal("2 texts are not cut. Engrave them?", here.Find<TextBlock>("TextOfferQuestion").Text);
        here.Click(here.Find<Button>("TextOfferYes"));
        here.WaitUntilIdle();
        Assert.False(here.Find<Button>("TextOfferYes").IsEffectivelyVisible);
        Assert.Equal(CutChoice.Text, here.Commands.Document.Current.Settings.Cut);
        here.Enter("CNCTEXT", "No");
        Assert.False(here.Find<Button>("TextOfferYes").IsEffectivelyVisible);

        here.Open(Write());
        here.WaitUntilIdle();
        here.Click(here.Find<Button>("TextOfferNo"));
        here.WaitUntilIdle();
        Assert.False(here.Find<Button>("TextOfferYes").IsEffectivelyVisible);
        Assert.Equal(CutChoice.None, here.Commands.Document.Current.Settings.Cut);
    });

    /// <summary>The typed line is on the canvas before it is entered.</summary>
    [Fact]
    public Task A_text_is_previewed_while_it_is_typed() => fixture.WithOperator(here =>
    {
        here.Open(Write());
        here.Enter("TEXT", "0,20", "5", "0");
        Assert.Empty(here.Window.Canvas.Commands!.Preview!(default));
        here.Hands.Type("HI");
        here.Step();
        var shown = here.Window.Canvas.Commands!.Preview!(default);
        Assert.InRange(shown.Max(part => Math.Max(part.Start.Y, part.End.Y)), 24.9, 25.1);
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();
        here.Enter("");

        Assert.Equal(["LH", "T", "HI"], here.Commands.Document.Current.Drawing!.Texts.Select(text => text.Content));
        Assert.Equal(4, here.Window.Canvas.Scene!.Shown.Entities.Count);
    });

    private static string Write()
    {
        var file = Path.Combine(Directory.CreateTempSubdirectory("engraver-texts-").FullName, "texts.dxf");
        File.WriteAllBytes(file, DxfText.WithEntities(s_entities).ToAscii());
        return file;
    }
}
