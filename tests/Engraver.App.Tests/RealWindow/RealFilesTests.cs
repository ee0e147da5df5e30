using Avalonia;
using Engraver.SoftwarePlatform.Tests.X11;
using Engraver.TestKit;

namespace Engraver.App.Tests.RealWindow;

/// <summary>Files in a real window: dropped by another program, chosen in the file dialog, saved under a new name.</summary>
[Collection(DesktopCollection.Name)]
public sealed class RealFilesTests
{
    private static readonly Point s_canvas = new(500, 200);

    /// <summary>In the full run: the fast subset drags files to a real window in <see cref="RealWindowTests"/> and drops them on a desktop in memory in
    /// <c>FileDropTests</c>.</summary>
    [FullRunXServerFact]
    public void A_drawing_that_another_program_drops_is_opened_and_a_second_one_after_it()
    {
        using var desktop = new ShownDesktop();
        desktop.Settle();
        Keep(desktop, "start-page");
        Assert.True(desktop.Drop(s_canvas, Sample("gasket.dxf")));
        desktop.WaitForTitle("gasket.dxf - CNC");
        desktop.Settle(); // the title changes before the command has ended, and a drop during a command is refused
        Assert.True(desktop.Drop(s_canvas, Sample("nameplate.dxf")));
        desktop.WaitForTitle("nameplate.dxf - CNC");
        Assert.Equal(0, desktop.Close());
    }

    [XServerFact]
    public void A_drawing_is_chosen_by_its_first_letters_and_saved_under_a_new_name()
    {
        var folder = Directory.CreateTempSubdirectory("files-");
        using (var desktop = new ShownDesktop())
        {
            desktop.Settle();
            var isChosen = IsChosen(desktop);
            for (var again = 0; again < 3 && !isChosen; again++) // a busy computer may need a second attempt
            {
                desktop.Press("Escape");
                isChosen = IsChosen(desktop);
            }

            Assert.True(isChosen);
            desktop.Settle();
            desktop.Enter("SAVEAS", Path.Combine(folder.FullName, "my plate"));
            desktop.WaitForTitle("my plate.dxf - CNC");
            Assert.Equal(0, desktop.Close());
        }

        Assert.True(File.Exists(Path.Combine(folder.FullName, "my plate.dxf")));
        folder.Delete(recursive: true);
    }

    private static bool IsChosen(ShownDesktop desktop)
    {
        desktop.Enter("OPEN");
        desktop.Settle(); // typed immediately, the folder would be the answer to the command
        desktop.Enter(RepositoryFolder.Samples);
        desktop.Settle();
        desktop.Type("gask");
        Keep(desktop, "file-dialog");
        desktop.Press("Return");
        return desktop.HasTitleSoon("gasket.dxf - CNC");
    }

    private static string Sample(string name) => Path.Combine(RepositoryFolder.Samples, name);

    private static void Keep(ShownDesktop desktop, string name) => File.WriteAllBytes(Path.Combine(ShownDesktop.Pictures, name + ".png"), desktop.Picture());
}
