using Avalonia.Controls;
using Avalonia.VisualTree;
using Engraver.App.StartPage;
using Engraver.TestKit;

namespace Engraver.App.Tests.StartPage;

/// <summary>The page on the empty canvas, and the submenu of recent drawings.</summary>
[Collection(DesktopCollection.Name)]
public sealed class StartPageTests(DesktopFixture fixture) : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("start-");

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public Task It_makes_room_for_a_drawing_and_comes_back_when_that_is_closed() => fixture.WithOperator(here =>
    {
        Assert.True(Page(here).IsVisible);
        here.Open("gasket.dxf");
        Assert.False(Page(here).IsVisible);
        here.Enter("CLOSE");

        Assert.True(Page(here).IsVisible);
    });

    [Fact]
    public Task A_recent_drawing_is_opened_with_a_click() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Open("paper-001.dxf");
        here.Enter("CLOSE");
        Settle(here);
        var texts = Entry(here, "gasket.dxf").GetVisualDescendants().OfType<TextBlock>().Select(text => text.Text).ToList();
        Assert.Equal(["gasket.dxf", RepositoryFolder.Samples, File.GetLastWriteTime(Path.Combine(RepositoryFolder.Samples, "gasket.dxf")).ToString("yyyy-MM-dd HH:mm", null)], texts);
        here.Click(Entry(here, "gasket.dxf"));
        here.WaitUntilIdle();

        Assert.Equal(70, here.Commands.Document.Current.Drawing?.Entities.Count);
    });

    [Fact]
    public Task A_drawing_that_is_gone_is_told_and_can_be_taken_out() => fixture.WithOperator(here =>
    {
        var path = Path.Combine(_folder.FullName, "plate.dxf");
        File.Copy(Path.Combine(RepositoryFolder.Samples, "gasket.dxf"), path);
        here.Enter("OPEN", path, "CLOSE");
        File.Delete(path);
        here.Window.Model.Recent.Refresh();
        Settle(here);
        Assert.Contains(Entry(here, "plate.dxf").GetVisualDescendants().OfType<TextBlock>(), text => text.Text == "not found");

        here.Click(Entry(here, "plate.dxf"));
        Assert.Contains(here.History, line => line.Contains("plate.dxf was not found", StringComparison.Ordinal));
        here.Click(here.Find<ItemsControl>("RecentList").GetVisualDescendants().OfType<Button>().First(button => button.Tag is "plate.dxf"));
        Settle(here);
        Assert.Empty(here.Commands.Settings.Current.RecentFiles);
    });

    [Fact]
    public Task A_sample_is_opened_with_a_click() => fixture.WithOperator(here =>
    {
        here.Until(() => here.Window.Model.StartPage.HasSamples);
        here.Step();
        here.Click(here.Find<ItemsControl>("SampleList").GetVisualDescendants().OfType<Button>().First(button => button.Tag is "gasket"));
        here.WaitUntilIdle();

        Assert.Equal(70, here.Commands.Document.Current.Drawing?.Entities.Count);
    });

    [Fact]
    public Task The_file_menu_lists_the_recent_drawings_and_opens_them() => fixture.WithOperator(here =>
    {
        var path = Path.Combine(_folder.FullName, "my_plate.dxf");
        File.Copy(Path.Combine(RepositoryFolder.Samples, "gasket.dxf"), path);
        here.Enter("OPEN", path);
        here.Open("gasket.dxf");
        here.Open("paper-001.dxf");
        File.Delete(path);
        here.Click(here.Find<MenuItem>("FileMenu"));
        var recent = here.Find<MenuItem>("FileMenu").Items.OfType<MenuItem>().First(item => item.Tag is "RECENT");
        here.Window.Model.Recent.Refresh();
        Settle(here);
        var entries = recent.Items.OfType<MenuItem>().ToList();
        Assert.Equal(["1  paper-001.dxf", "2  gasket.dxf", "3  my__plate.dxf (not found)", "List in the command window"], entries.Select(entry => entry.Header));
        Assert.Equal([true, true, false, true], entries.Select(entry => entry.IsEnabled));

        here.Hands.Click(here.MiddleOf(recent));
        here.Step();
        recent.Open();
        here.Step();
        here.Click(entries[1]);
        here.WaitUntilIdle();
        Assert.Equal(70, here.Commands.Document.Current.Drawing?.Entities.Count);
    });

    private static StartPageView Page(Operator here) => here.Find<StartPageView>("StartSheet");

    private static void Settle(Operator here)
    {
        here.Until(() => !here.Window.Model.Recent.IsChecking);
        here.Step();
    }

    private static Button Entry(Operator here, string name) => here.Find<ItemsControl>("RecentList").GetVisualDescendants().OfType<Button>().First(button => button.Tag is string path && Path.IsPathRooted(path) && Path.GetFileName(path) == name);
}
