using Avalonia;
using Avalonia.Input;
using Engraver.TestKit;

namespace Engraver.App.Tests.FileDialogs;

/// <summary>Files that are dragged from another program and dropped on the window.</summary>
[Collection(DesktopCollection.Name)]
public sealed class FileDropTests(DesktopFixture fixture)
{
    private static readonly Point s_canvas = new(500, 300);

    [Fact]
    public Task A_drawing_is_opened() => fixture.WithOperator(here =>
    {
        Assert.Equal(DragDropEffects.Copy, here.Hands.DropFiles(s_canvas, [Sample("gasket.dxf")]));
        here.WaitUntilIdle();

        Assert.Equal(70, here.Commands.Document.Current.Drawing?.Entities.Count);
        Assert.Equal(Path.GetDirectoryName(Sample("gasket.dxf")), here.Commands.Settings.Current.FileFolders.GetValueOrDefault("drawing"));
    });

    [Fact]
    public Task A_script_is_run() => fixture.WithOperator(here =>
    {
        here.Hands.DropFiles(s_canvas, [Sample("first-job.scr")]);
        here.WaitUntilIdle();

        Assert.NotNull(here.Commands.Document.Current.Drawing);
    });

    [Fact]
    public Task What_is_neither_is_refused() => fixture.WithOperator(here =>
    {
        Assert.Equal(DragDropEffects.None, here.Hands.DropFiles(s_canvas, [Sample("README.md")]));
        here.WaitUntilIdle();

        Assert.Null(here.Commands.Document.Current.Drawing);
    });

    [Fact]
    public Task Of_several_drawings_the_first_is_opened_and_it_is_said() => fixture.WithOperator(here =>
    {
        here.Hands.DropFiles(s_canvas, [Sample("README.md"), Sample("paper-001.dxf"), Sample("gasket.dxf")]);
        here.WaitUntilIdle();

        Assert.Equal(4, here.Commands.Document.Current.Drawing?.Entities.Count);
        Assert.Contains(here.History, line => line.Contains("Only paper-001.dxf was opened", StringComparison.Ordinal));
    });

    [Fact]
    public Task Edits_are_asked_about_first() => fixture.WithOperator(here =>
    {
        var folder = Directory.CreateTempSubdirectory("drop-");
        var path = Path.Combine(folder.FullName, "plate.dxf");
        File.Copy(Sample("gasket.dxf"), path);
        here.Enter("OPEN", path, "ERASE", "ALL", "");
        here.Hands.DropFiles(s_canvas, [Sample("paper-001.dxf")]);
        here.WaitUntilIdle();
        Assert.True(here.Window.Model.Files.Question.IsOpen);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
        Assert.Equal(0, here.Commands.Document.Current.Drawing!.Entities.Count);

        here.Hands.DropFiles(s_canvas, [Sample("paper-001.dxf")]);
        here.Enter("Open");
        here.WaitUntilIdle();
        Assert.Equal(4, here.Commands.Document.Current.Drawing!.Entities.Count);
        Assert.Equal(File.ReadAllText(Sample("gasket.dxf")), File.ReadAllText(path));
        folder.Delete(recursive: true);
    });

    [Fact]
    public Task An_open_dialog_takes_it() => fixture.WithOperator(here =>
    {
        here.Enter("CNCPROFILE");
        here.Hands.DropFiles(s_canvas, [Sample("machine-mill.json")]);
        here.WaitUntilIdle();

        Assert.False(FileDialogTests.Dialog(here).IsOpen);
        Assert.EndsWith("machine-mill.json", here.Commands.Settings.Current.LastProfile, StringComparison.Ordinal);
    });

    private static string Sample(string name) => Path.Combine(RepositoryFolder.Samples, name);
}
