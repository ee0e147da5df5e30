using Avalonia.Controls;
using Engraver.App.Programs;
using Engraver.Workbench.Views;

namespace Engraver.App.Tests.Tabs;

[Collection(DesktopCollection.Name)]
public sealed class HiddenPageTests(DesktopFixture fixture)
{
    [Fact]
    public Task A_program_is_posted_when_its_page_is_seen() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        Assert.True(here.Desk.Derived.Current.Motion is not null && !here.Desk.Derived.Current.IsPosted);

        here.Show("Program");
        Assert.True(here.Desk.Derived.Current.IsPosted && here.Find<ListBox>("LineList").ItemCount > 100);
        var page = (ProgramModel)here.Find<ListBox>("LineList").DataContext!;
        here.Show("Layers");
        Assert.False(page.IsPageVisible);
        here.Open("paper-001.dxf");
        here.WaitUntilIdle();

        Assert.False(here.Desk.Derived.Current.IsPosted);
        Assert.Empty(page.Rows);
        here.Show("Program");
        Assert.NotEmpty(page.Rows);
    });

    [Fact]
    public Task Overlays_are_made_when_they_are_shown() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Until(() => here.Window.CanvasSource.IsCurrent && here.Window.Canvas.IsUpToDate);
        Assert.False(here.Window.Canvas.Overlay!.Deferred.IsAnyCreated);
        Assert.True(here.Window.Canvas.Overlay.MoveCount > 0);

        here.Commands.View.Change(state => state with { Shown = state.Shown | CanvasLayers.CutPath });
        here.Until(() => here.Window.Canvas.IsUpToDate);
        Assert.True(here.Window.Canvas.Overlay.Deferred.CutPath.IsValueCreated && !here.Window.Canvas.Overlay.Deferred.Contours.IsValueCreated);
        Assert.Equal(here.Window.Canvas.Overlay.MoveCount, here.Window.Canvas.Overlay.CutPath.Count);
    });
}
