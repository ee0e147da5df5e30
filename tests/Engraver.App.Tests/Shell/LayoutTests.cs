using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.CommandWindow;
using Engraver.App.Tabs;
using Engraver.Workbench.Settings;

namespace Engraver.App.Tests.Shell;

/// <summary>The window on small and large screens, in pixels of the screen and at the display scale.</summary>
[Collection(DesktopCollection.Name)]
public sealed class LayoutTests(DesktopFixture fixture)
{
    /// <summary>The controls that are always visible: the machine's keys, the command line, the middle of the canvas, the status bar.</summary>
    private static readonly string[] s_always = ["StopKey", "HoldKey", "StartKey", "ArmKey", "XText", "StateText", "FeedText", "ToolText", "ProgressText", "PlayButton", "CoordinateText", "MainMenu"];

    public static TheoryData<int, int, double> Screens => new() { { 1366, 768, 1.25 }, { 1280, 720, 1.5 }, { 3840, 2160, 2.0 }, { 1024, 700, 1.0 }, { 1280, 800, 1.0 } };

    [Theory]
    [MemberData(nameof(Screens))]
    public Task Stop_the_command_line_and_the_canvas_are_there_with_every_page_and_palette(int width, int height, double scale) => fixture.WithOperator(here =>
    {
        LookAt(here, width, height, scale);
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", "sim:");
        foreach (var page in PagesOf(here))
        {
            here.Show(page);
            foreach (var name in s_always) AssertInside(here, here.Find<Control>(name), $"{name} with {page} open");
            AssertInside(here, here.Find<TextBox>("LineBox"), $"the command line with {page} open");
            AssertInside(here, here.Find<Control>("StatusLine"), $"the status bar with {page} open");
            var canvas = here.Window.Canvas.Bounds;
            Assert.True(canvas is { Width: >= 200, Height: >= 100 }, $"the canvas with {page} open is {canvas}");
            AssertInside(here, here.Window.Canvas, $"the canvas with {page} open");
        }

        here.Hands.Type("ZO");
        here.Step();
        AssertInside(here, here.Find<TextBox>("LineBox"), "the command line");
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
    });

    /// <summary>The canvas takes most of a small screen until the operator opens a panel; the command line shows the last message beside it.</summary>
    [Fact]
    public Task On_a_small_screen_the_canvas_has_the_room_and_panels_are_opened_at_will() => fixture.WithOperator(here =>
    {
        LookAt(here, 1280, 720, 1.5);
        here.Open("nameplate.dxf");
        var canvas = here.Window.Canvas.Bounds;
        Assert.True(canvas is { Width: >= 720, Height: >= 210 }, $"the canvas is {canvas.Size}");
        here.Enter("CNCCONNECT", "sim:");
        Assert.StartsWith("Connected to", here.Find<TextBlock>("LastText").Text, StringComparison.Ordinal);
        AssertInside(here, here.Find<TextBlock>("LastText"), "the last line of the history");
        Assert.Equal(canvas, here.Window.Canvas.Bounds);
        here.Enter("ZOOM");
        Assert.Equal(canvas, here.Window.Canvas.Bounds); // points on the canvas keep their positions
        here.Click(here.Find<PromptOptions>("LineOptions").GetVisualDescendants().OfType<Button>().First());
        here.WaitUntilIdle();
        Assert.Null(here.Desk.Prompt.Command);

        here.Show("Table");
        here.Show("Layers");
        Assert.True(here.Window.Canvas.Bounds.Width < 600 && here.Window.Canvas.Bounds.Height < 150);
        here.Hands.SetScale(1.0);
        here.Hands.Resize(new Size(1280, 800));
        here.Step();
        Assert.Empty(here.Commands.Settings.Current.FoldedPanels);
        Assert.True(here.Find<PageTabs>("Palettes").Bounds.Width > 200);
    });

    [Theory]
    [MemberData(nameof(Screens))]
    public Task No_text_is_cut_off_on_any_page(int width, int height, double scale) => fixture.WithOperator(here =>
    {
        LookAt(here, width, height, scale);
        var cut = new SortedSet<string>(StringComparer.Ordinal);
        LookAtPages("empty");
        here.Show("Command"); // text typed in the terminal stays there
        here.Open("gasket.dxf");
        here.Enter("HELP", "", "CNCCONNECT", "sim:");
        LookAtPages("with a drawing");
        Assert.True(cut.Count == 0, string.Join('\n', cut));

        void LookAtPages(string state)
        {
            foreach (var page in PagesOf(here))
            {
                here.Show(page);
                foreach (var text in TextFit.CutOff(here.Window)) cut.Add($"{page}, {state}: {text}");
                foreach (var text in new[] { "MachineStrip", "StatusLine", "PlaybackLine", "Pages", "Palettes" }.SelectMany(name => TextFit.Overlapping(here.Find<Control>(name)))) cut.Add($"{page}, {state}: {text}");
            }
        }
    });

    /// <summary>Touch targets are at least 44 x 44, STOP is larger.</summary>
    [Theory]
    [MemberData(nameof(Screens))]
    public Task Keys_of_the_machine_strip_are_large_enough_for_a_finger(int width, int height, double scale) => fixture.WithOperator(here =>
    {
        LookAt(here, width, height, scale);
        var keys = here.Find<Control>("MachineStrip").GetVisualDescendants().OfType<Button>().Where(key => key.IsEffectivelyVisible).ToList();

        Assert.Equal(8, keys.Count);
        Assert.All(keys, key => Assert.True(key.Bounds is { Width: >= 44, Height: >= 44 }, $"{key.Name} is {key.Bounds.Size}"));
        Assert.True(here.Find<Button>("StopKey").Bounds is { Width: >= 64, Height: >= 64 });
    });

    [Fact]
    public Task The_window_opens_no_larger_than_the_screen()
    {
        var folder = Directory.CreateTempSubdirectory("desktop-");
        new SettingsSession(Path.Combine(folder.FullName, "desktop.json"), TimeProvider.System).Change(settings => settings with { WindowWidth = 5000, WindowHeight = 4000 });
        return Look();

        async Task Look()
        {
            await fixture.WithOperator(here =>
            {
                Assert.InRange(here.Window.Width, 1000, fixture.Desktop.ScreenSize.Width);
                Assert.InRange(here.Window.Height, 700, fixture.Desktop.ScreenSize.Height - 1);
            }, folder.FullName);
            folder.Delete(recursive: true);
        }
    }

    /// <summary>In an even lower window the last entry of a menu can be reached, and the menu ends inside the window.</summary>
    [Fact]
    public Task A_long_menu_scrolls_in_a_low_window() => fixture.WithOperator(here =>
    {
        here.Window.MinHeight = 200;
        LookAt(here, 800, 260, 1.0);
        var machine = here.Find<MenuItem>("MachineMenu");
        here.Click(machine);
        var last = machine.Items.OfType<MenuItem>().Last();
        var list = last.GetVisualAncestors().OfType<ScrollViewer>().First();

        AssertInside(here, list, "the menu");
        Assert.True(list.Extent.Height > list.Viewport.Height, "the menu is no longer than the window: the test shows nothing");
        for (var i = 0; i < machine.ItemCount && !last.IsSelected; i++) here.Hands.Press(Key.Down);
        here.Step();
        AssertInside(here, last, "the last entry");
        here.Hands.Press(Key.Escape);
        here.Step();
    });

    [Fact]
    public Task Tools_name_their_command_and_its_alias() => fixture.WithOperator(here =>
    {
        var tips = here.Find<ItemsControl>("ToolColumn").GetVisualDescendants().OfType<Button>().ToDictionary(tool => $"{tool.Tag} {ToolTip.GetTip(tool)}", tool => tool);

        Assert.All(tips, pair => Assert.Contains((string)pair.Value.Tag!, ((string)ToolTip.GetTip(pair.Value)!), StringComparison.Ordinal));
        Assert.Contains(tips.Keys, tip => tip.EndsWith("(ZOOM, Z)", StringComparison.Ordinal));
    });

    internal static void LookAt(Operator here, int width, int height, double scale)
    {
        here.Hands.SetScale(scale);
        here.Hands.Resize(new Size(width / scale, height / scale));
        here.Step();
    }

    private static List<string> PagesOf(Operator here) => [.. here.Window.GetVisualDescendants().OfType<PageTabs>().SelectMany(tabs => tabs.Pages).Select(page => page.Key)];

    private static void AssertInside(Operator here, Visual control, string what)
    {
        var box = new Rect(control.Bounds.Size).TransformToAABB(control.TransformToVisual(here.Window)!.Value);
        Assert.True(control.IsEffectivelyVisible && box is { Width: > 0, Height: > 0 } && new Rect(here.Window.Bounds.Size).Inflate(0.5).Contains(box), $"{what} is at {box} of {here.Window.Bounds.Size}");
    }
}
