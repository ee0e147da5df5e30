using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Settings;

public sealed class SettingsFileTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-settings-");
    private readonly ManualTimeProvider _time = new();

    private string File => Path.Combine(_folder.FullName, "sub", "desktop.json");

    [Fact]
    public void Everything_that_is_written_is_read_again()
    {
        var settings = new DesktopSettings
        {
            Theme = DesktopTheme.Light, Scale = 1.5, WindowWidth = 1024, WindowHeight = 700, WindowMaximised = true, LastAddress = "sim:", LastProfile = "p.json",
        }.WithRecent("/a.dxf").WithRecent("/b.dxf").WithVariable("PICKBOX", 7).WithPanelSize("right", 320).WithPanelFolded("bottom", folded: true).WithView("/a.dxf", new SavedView(1, 2, 3));

        SettingsFile.Save(File, settings);
        var (read, finding) = SettingsFile.Load(File, _time);

        Assert.Null(finding);
        Assert.Equal(["/b.dxf", "/a.dxf"], read.RecentFiles);
        Assert.Equal((DesktopTheme.Light, 1.5, 1024.0, 700.0, true, "sim:", "p.json"), (read.Theme, read.Scale, read.WindowWidth, read.WindowHeight, read.WindowMaximised, read.LastAddress, read.LastProfile));
        Assert.Equal((7.0, 320.0, "bottom", new SavedView(1, 2, 3)), (read.Variables["PICKBOX"], read.PanelSizes["right"], read.FoldedPanels.Single(), read.Views["/a.dxf"]));
        Assert.Single(Directory.GetFiles(Path.GetDirectoryName(File)!));
    }

    [Theory]
    [InlineData("{ \"theme\": ")]
    [InlineData("null")]
    [InlineData("[]")]
    [InlineData("{ \"scale\": \"big\" }")]
    public void A_broken_file_is_said_and_set_aside_and_never_lost(string text)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(File)!);
        System.IO.File.WriteAllText(File, text);

        var session = new SettingsSession(File, _time);
        session.Change(settings => settings.WithRecent("/a.dxf"));

        var aside = Directory.GetFiles(Path.GetDirectoryName(File)!, "*.broken-*").Single();
        Assert.Equal(text, System.IO.File.ReadAllText(aside));
        Assert.Equal(["/a.dxf"], SettingsFile.Load(File, _time).Settings.RecentFiles);
    }

    [Fact]
    public void Values_that_no_window_can_have_are_the_first_ones_again()
    {
        Directory.CreateDirectory(Path.GetDirectoryName(File)!);
        System.IO.File.WriteAllText(File, "{ \"scale\": 99, \"windowWidth\": -5, \"recentFiles\": null, \"views\": null }");

        var (read, finding) = SettingsFile.Load(File, _time);

        Assert.Null(finding);
        Assert.Equal((1.0, 1280.0, 800.0, 0), (read.Scale, read.WindowWidth, read.WindowHeight, read.RecentFiles.Count + read.Views.Count + read.Variables.Count + read.PanelSizes.Count + read.FoldedPanels.Count));
    }

    [Fact]
    public void Only_the_last_ten_files_and_their_views_are_remembered()
    {
        var settings = DesktopSettings.Default;
        for (var i = 0; i < 12; i++) settings = settings.WithRecent($"/{i}.dxf").WithView($"/{i}.dxf", new SavedView(i, 0, 1));
        settings = settings.WithRecent("/5.dxf");

        Assert.Equal(10, settings.RecentFiles.Count);
        Assert.Equal(["/5.dxf", "/11.dxf"], settings.RecentFiles.Take(2));
        Assert.Equal(settings.RecentFiles.Order(), settings.Views.Keys.Order());
    }

    [Fact]
    public void A_place_that_cannot_be_written_is_said_and_stops_nobody()
    {
        System.IO.File.WriteAllText(Path.Combine(_folder.FullName, "sub"), "a file where the folder should be");
        var session = new SettingsSession(File, _time);
        session.Change(settings => settings with { Scale = 2 });

        Assert.Equal(2.0, session.Current.Scale);
        Assert.Contains("cannot be saved", session.Finding, StringComparison.Ordinal);
    }

    [Fact]
    public async Task What_was_chosen_is_there_at_the_next_start()
    {
        var environment = new CommandEnvironment { Folder = _folder.FullName, RunJournalFolder = _folder.FullName, SettingsFile = File };
        await using (var first = new CommandSession(environment, CommandCatalog.Built()))
        {
            foreach (var input in new[] { "OPEN", Commands.CommandTestSession.Sample("gasket.dxf"), "THEME", "Light", "GRID", "OFF", "CURSORSIZE", "20", "CNCCONNECT", "sim:" }) await first.EnterAsync(input, CancellationToken.None);
        }

        await using var second = new CommandSession(environment, CommandCatalog.Built());
        Assert.Equal((DesktopTheme.Light, false), (second.View.Current.Theme, second.View.Current.Grid));
        Assert.Equal(("sim:", 20.0), (second.Settings.Current.LastAddress, second.Settings.Current.Variables["CURSORSIZE"]));
        Assert.Equal("gasket.dxf", Path.GetFileName(second.Settings.Current.RecentFiles.Single()));
    }

    public void Dispose() => _folder.Delete(recursive: true);
}
