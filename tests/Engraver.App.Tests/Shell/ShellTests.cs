using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Styling;
using Avalonia.VisualTree;
using Engraver.App.Properties;
using Engraver.App.Shell;
using Engraver.App.StatusBar;
using Engraver.App.Tables;
using Engraver.App.Tabs;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Commands;

namespace Engraver.App.Tests.Shell;

[Collection(DesktopCollection.Name)]
public sealed class ShellTests(DesktopFixture fixture)
{
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public Task What_is_typed_is_seen_even_when_another_page_is_in_front_or_all_are_folded(bool folded) => fixture.WithOperator(here =>
    {
        here.Show("Table");
        if (folded) here.Hands.Press(Key.D9, RawInputModifiers.Control);
        here.Step();
        here.Hands.Type("ZO");
        here.Step();

        Assert.True(here.Find<TextBox>("LineBox").IsEffectivelyVisible);
        Assert.Equal("ZO", here.Find<TextBox>("LineBox").Text);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
    });

    /// <summary>The menus keep the focus only while they are open.</summary>
    [Theory]
    [InlineData("Escape")]
    [InlineData("Title")]
    [InlineData("Canvas")]
    [InlineData("Entry")]
    [InlineData("OnCanvas")]
    public Task What_is_typed_after_a_menu_goes_to_the_command_line(string way) => fixture.WithOperator(here =>
    {
        var view = here.Find<MenuItem>("ViewMenu");
        if (way == "OnCanvas") here.Hands.Click(here.MiddleOf(here.Window.Canvas), MouseButton.Right);
        else here.Click(view);
        here.Step();
        Assert.True(here.Window.GetVisualDescendants().OfType<MenuItem>().Count(item => item.IsEffectivelyVisible && item.Tag is string) > 5, "no menu is open");
        if (way == "Title") here.Click(view);
        else if (way == "Canvas") here.Click(here.Window.Canvas);
        else if (way == "Entry") here.Click(view.Items.OfType<MenuItem>().First());
        else here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
        here.Hands.Type("E");
        here.Hands.Press(Key.F2);
        here.Step();

        Assert.Equal(way == "Entry" ? "ZOOM" : null, here.Desk.Prompt.Command);
        Assert.Equal("E", here.Window.Model.Command.Line);
        Assert.True(here.Find<PageTabs>("Pages").Bounds.Height > 250, "F2 was not heard");
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
    });

    [Fact]
    public Task The_main_job_is_done_with_the_keyboard_alone() => fixture.WithOperator(here =>
    {
        here.Enter("OPEN", "nameplate.dxf", "CHECK", "CNCORDER", "Nearest", "CNCCONNECT", "sim:", "CNCARM", "Stream", "CNCRUN");

        Assert.Equal(JobOutcome.Complete, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        Assert.Contains("nameplate.dxf", here.Window.Title, StringComparison.Ordinal);
    });

    /// <summary>The file that was saved last becomes the file of the drawing.</summary>
    [Fact]
    public Task The_title_names_the_file_that_was_saved_last() => fixture.WithOperator(here =>
    {
        var folder = Directory.CreateTempSubdirectory("desktop-");
        here.Enter("OPEN", "nameplate.dxf", "SAVEAS", Path.Combine(folder.FullName, "other.dxf"));
        here.Step();
        folder.Delete(recursive: true);
        Assert.Contains("other.dxf", here.Window.Title, StringComparison.Ordinal);
    });

    [Fact]
    public Task Settings_are_kept_between_two_starts()
    {
        var folder = Directory.CreateTempSubdirectory("desktop-");
        return InTurn(folder, Change, Look);

        static void Change(Operator here)
        {
            here.Open("gasket.dxf");
            here.Enter("THEME", "Light", "ORTHO", "ON");
            here.Hands.Resize(new Size(1400, 900));
            here.Hands.Press(Key.D1, RawInputModifiers.Control);
            here.Step();
        }

        static void Look(Operator here)
        {
            here.Step();
            Assert.Equal(ThemeVariant.Light, Application.Current!.RequestedThemeVariant);
            Assert.True(here.Commands.View.Current.Ortho);
            Assert.Equal(1400, here.Window.Width);
            Assert.Contains("gasket.dxf", here.Commands.Settings.Current.RecentFiles.Single(), StringComparison.Ordinal);
            Assert.True(here.Find<PageTabs>("Palettes").Bounds.Width < 40);
            here.Hands.Press(Key.D1, RawInputModifiers.Control);
            here.Step();
            Assert.True(here.Find<PageTabs>("Palettes").Bounds.Width > 200);
            here.Enter("THEME", "Dark");
        }
    }

    /// <summary>The height set with F2 is not the normal height: the next start has the normal one, and F2 restores the last enlarged one.</summary>
    [Fact]
    public Task The_room_of_the_history_is_kept_beside_the_usual_one()
    {
        var folder = Directory.CreateTempSubdirectory("desktop-");
        return InTurn(folder, Enlarge, Look);

        static void Enlarge(Operator here)
        {
            here.Hands.Resize(new Size(1400, 1000));
            here.Hands.Press(Key.F2);
            here.Step();
            var pages = here.Find<PageTabs>("Pages");
            var corner = pages.TranslatePoint(new Point(200, -2), here.Window)!.Value;
            here.Hands.Drag(corner, corner - new Point(0, 80));
            here.Step();
            Assert.InRange(pages.Bounds.Height, 480, 520);
        }

        static void Look(Operator here)
        {
            here.Step();
            Assert.InRange(here.Find<PageTabs>("Pages").Bounds.Height, 155, 175);
            here.Hands.Press(Key.F2);
            here.Step();
            Assert.InRange(here.Find<PageTabs>("Pages").Bounds.Height, 480, 520);
            here.Hands.Press(Key.F2);
            here.Step();
            Assert.InRange(here.Find<PageTabs>("Pages").Bounds.Height, 155, 175);
        }
    }

    [Fact]
    public Task Closing_with_edits_asks_and_a_second_x_is_no_answer() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("ERASE", "L", "");
        here.Hands.RequestClose();
        Assert.Equal(["Save", "Don't save", "Cancel"], Question(here).Answers.Select(answer => answer.Label));
        Assert.Equal("gasket.dxf has unsaved changes. Save them before closing the window?", here.Find<TextBlock>("QuestionText").Text);
        for (var i = 0; i < 3; i++) here.Hands.RequestClose();

        Assert.True(here.Window.IsVisible && Question(here).IsOpen);
        here.Hands.Press(Key.Escape);
        here.Step();
        Assert.True(here.Window.IsVisible && !Question(here).IsOpen);
        here.Hands.RequestClose();
        Assert.True(Question(here).IsOpen, "Cancel was taken for an answer of the next request");
        here.Hands.Press(Key.Escape);
        here.Enter("U");
        here.Hands.RequestClose();
        Assert.False(here.Window.IsVisible);
    });

    [Theory]
    [InlineData("Save", true)]
    [InlineData("Don't save", false)]
    public Task The_answer_closes_the_window_and_decides_about_the_file(string answer, bool saved)
    {
        var folder = Directory.CreateTempSubdirectory("closing-").FullName;
        var path = Path.Combine(folder, "plate.dxf");
        File.Copy(Path.Combine(RepositoryFolder.Samples, "gasket.dxf"), path);
        var before = File.ReadAllText(path);
        return fixture.WithOperator(here =>
        {
            here.Open(path);
            here.Enter("ERASE", "L", "");
            here.Hands.RequestClose();
            here.Hands.Type(answer[..1]);
            here.Hands.Press(Key.Enter);
            here.Until(() => !here.Window.IsVisible);

            Assert.Equal(saved, File.ReadAllText(path) != before);
            Directory.Delete(folder, recursive: true);
        });
    }

    [Fact]
    public Task A_save_that_fails_keeps_the_window_open()
    {
        var folder = Directory.CreateTempSubdirectory("closing-").FullName;
        var path = Path.Combine(folder, "plate.dxf");
        File.Copy(Path.Combine(RepositoryFolder.Samples, "gasket.dxf"), path);
        return fixture.WithOperator(here =>
        {
            here.Open(path);
            here.Enter("ERASE", "L", "");
            Directory.Delete(folder, recursive: true); // the folder it was read from is gone
            File.WriteAllText(folder, "no folder");
            here.Hands.RequestClose();
            here.Hands.Press(Key.Enter);
            here.WaitUntilIdle();

            Assert.True(here.Window.IsVisible);
            Assert.True(here.Commands.Document.IsEdited);
            Assert.Equal(Engraver.Workbench.Commands.MessageKind.Error, here.Window.Model.Command.History[^1].Kind);
            here.Hands.RequestClose();
            Assert.True(Question(here).IsOpen);
            File.Delete(folder);
        });
    }

    /// <summary>A new drawing has no file: Save asks for one, and the window stays open until it is closed again.</summary>
    [Fact]
    public Task A_new_drawing_is_asked_for_its_file() => fixture.WithOperator(here =>
    {
        here.Enter("NEW", "", "LINE", "0,0", "10,0", "");
        Assert.True(here.Commands.Document.IsEdited, string.Join('\n', here.History));
        here.Hands.RequestClose();
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();

        Assert.True(here.Window.IsVisible && here.Window.Model.Files.Dialog.IsOpen);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
        Assert.True(here.Window.IsVisible && here.Commands.Document.IsEdited);
    });

    /// <summary>Regression: a warning of QUIT was above the line that had caused it.</summary>
    [Fact]
    public Task What_the_window_says_stands_behind_what_the_session_said_before() => fixture.WithOperator(here =>
    {
        Task.Run(() => here.Commands.EnterAsync("nonsense", CancellationToken.None)).Wait(); // sent, but not delivered while this thread waits
        here.Desk.Notifications.Write(MessageKind.Warning, "behind it");
        here.Step();

        Assert.Equal("behind it", here.History.Last());
        Assert.Contains(here.History, line => line.Contains("nonsense", StringComparison.Ordinal));
    });

    /// <summary>QUIT closes the window and asks the same questions. EXIT is an alias.</summary>
    [Fact]
    public Task Quit_asks_about_edits_and_closes_the_window() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("ERASE", "L", "", "EXIT");
        here.Until(() => Question(here).IsOpen);
        here.Hands.Press(Key.Escape);
        here.Enter("");
        Assert.True(here.Window.IsVisible && !Question(here).IsOpen, "Enter alone was the second QUIT");
        here.Hands.Press(Key.Q, RawInputModifiers.Control);
        here.Until(() => Question(here).IsOpen);
        Assert.True(here.Window.IsVisible);
        here.Hands.Type("D");
        here.Hands.Press(Key.Enter);
        here.Until(() => !here.Window.IsVisible);
    });

    private static Engraver.App.FileDialogs.QuestionModel Question(Operator here) => here.Window.Model.Files.Question;

    [Fact]
    public Task Objects_that_are_only_hidden_do_not_hold_the_window() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("HIDEOBJECTS", "L", "");
        here.Window.Close();
        here.Step();

        Assert.False(here.Window.IsVisible);
    });

    [Fact]
    public Task Control_z_never_closes_the_drawing() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("ERASE", "L", "");
        for (var i = 0; i < 3; i++) here.Hands.Press(Key.Z, RawInputModifiers.Control);
        here.WaitUntilIdle();

        Assert.Equal(4, here.Commands.Document.Current.Drawing?.Entities.Count);
        Assert.Contains("Everything has been undone.", here.History);
    });

    [Fact]
    public Task A_switch_is_no_answer_to_a_question_for_a_name() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("FILEDIA", "0", "SAVEAS");
        here.Hands.Press(Key.F7);
        here.WaitUntilIdle();

        Assert.Equal((false, "SAVEAS"), (here.Commands.View.Current.Grid, here.Desk.Prompt.Command));
    });

    [Fact]
    public Task Control_a_and_delete_act_on_the_drawing_and_in_text_on_the_text() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Hands.Press(Key.A, RawInputModifiers.Control);
        here.WaitUntilIdle();
        Assert.Equal(4, here.Commands.Document.Current.Selection.Count);
        here.Hands.Type("li");
        here.Hands.Press(Key.A, RawInputModifiers.Control);
        here.Hands.Press(Key.Delete);
        here.WaitUntilIdle();
        Assert.Equal("", here.Window.Model.Command.Line);
        Assert.Equal(4, here.Commands.Document.Current.Drawing!.Entities.Count);
        here.Hands.Press(Key.Delete);
        here.WaitUntilIdle();
        Assert.True(here.Commands.Document.Current.Drawing!.Entities.Count == 0, "nothing was erased");
        here.Hands.Press(Key.Z, RawInputModifiers.Control);
        here.WaitUntilIdle();
        here.Enter("MOVE");
        here.Hands.Press(Key.A, RawInputModifiers.Control);
        here.Hands.Press(Key.Delete);
        here.WaitUntilIdle();
        Assert.Equal("MOVE", here.Desk.Prompt.Command);
        Assert.Contains("4 found, 4 total", here.History);
    });

    [Fact]
    public Task Undoing_what_is_typed_for_the_controller_undoes_nothing_of_the_drawing() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("ERASE", "L", "");
        here.Show("Terminal");
        here.Click(here.Find<TextBox>("LineBox"));
        here.Hands.Type("MG 1");
        here.Hands.Press(Key.Z, RawInputModifiers.Control);
        here.WaitUntilIdle();

        Assert.Equal(3, here.Commands.Document.Current.Drawing!.Entities.Count);
    });

    [Fact]
    public Task Control_0_leaves_nothing_but_the_canvas_and_brings_all_back() => fixture.WithOperator(here =>
    {
        here.Step();
        var before = here.Window.Canvas.Bounds.Size;
        here.Hands.Press(Key.D1, RawInputModifiers.Control);
        here.Hands.Press(Key.D0, RawInputModifiers.Control);
        here.Step();
        Assert.True(here.Window.Canvas.Bounds.Width > before.Width + 300 && here.Window.Canvas.Bounds.Height > before.Height + 100, $"{here.Window.Canvas.Bounds}");
        here.Hands.Press(Key.D0, RawInputModifiers.Control);
        here.Step();

        Assert.Equal(before, here.Window.Canvas.Bounds.Size);
    });

    [Fact]
    public Task What_is_short_or_cut_off_has_a_tip() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        var switches = here.Find<ItemsControl>("SwitchList").GetVisualDescendants().OfType<Avalonia.Controls.Primitives.ToggleButton>().ToList();
        Assert.Equal(6, switches.Count);
        Assert.All(switches, button => Assert.Contains("(F", ToolTip.GetTip(button) as string, StringComparison.Ordinal));
        var names = here.Find<ListBox>("LayerList").GetVisualDescendants().OfType<TextBlock>().Where(text => text.TextTrimming != Avalonia.Media.TextTrimming.None).ToList();
        Assert.Equal(5, names.Count);
        Assert.All(names, name => Assert.Equal(name.Text, ToolTip.GetTip(name)));
    });

    [Fact]
    public Task Pages_are_made_when_they_are_first_shown() => fixture.WithOperator(here =>
    {
        var made = here.Window.GetVisualDescendants().OfType<PageTabs>().SelectMany(tabs => tabs.Pages).Where(page => page.IsCreated).Select(page => page.Key);
        Assert.Equal(["Command", "Layers"], made.Order(StringComparer.Ordinal));

        here.Show("Job");

        Assert.True(here.Find<PageTabs>("Palettes").Pages.Single(page => page.Key == "Job").IsCreated);
    });

    [Fact]
    public Task Status_switches_and_function_keys_do_the_same() => fixture.WithOperator(here =>
    {
        var grid = here.Commands.View.Current.Grid;
        here.Click(here.Find<ItemsControl>("SwitchList").GetVisualDescendants().OfType<Avalonia.Controls.Primitives.ToggleButton>().Single(button => button.DataContext is StatusSwitch { Name: "GRID" }));
        here.WaitUntilIdle();
        Assert.Equal(!grid, here.Commands.View.Current.Grid);
        here.Hands.Press(Key.F7);
        here.WaitUntilIdle();

        Assert.Equal(grid, here.Commands.View.Current.Grid);
    });

    [Fact]
    public Task The_smallest_window_cuts_nothing_off() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(new Size(1024, 700));
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", "sim:");
        var whole = new Rect(0, 0, 1024, 700);
        foreach (var name in new[] { "ArmKey", "StartKey", "StopKey", "PlayButton", "TimeText", "CoordinateText", "SwitchList", "XText", "YText", "ProgressText", "MainMenu" })
        {
            var control = here.Find<Control>(name);
            var box = new Rect(control.Bounds.Size).TransformToAABB(control.TransformToVisual(here.Window)!.Value);
            Assert.True(box.Width > 0 && whole.Contains(box), $"{name} at {box}");
        }

        here.Enter("CNCARM", "Stream", "CNCRUN");
        Assert.Equal("00:00 left", here.Find<TextBlock>("TimeLeftText").Text);
        Assert.Equal("70 / 70", here.Find<TextBlock>("SegmentsText").Text);
        Assert.All(here.Find<Control>("MachineStrip").GetVisualDescendants().OfType<TextBlock>().Where(text => text.IsEffectivelyVisible), text => Assert.False(text.TextLayout.TextLines.Any(line => line.HasCollapsed || line.HasOverflowed), text.Text));
        Assert.Equal("", CutOff(here));
        here.Hands.Press(Key.F2);
        here.Step();
        Assert.Equal("", CutOff(here));
        here.Hands.Press(Key.F2);
        here.Step();
    });

    [Fact]
    public Task The_smallest_window_has_room_for_a_z_axis_and_both_overrides() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(new Size(1024, 700));
        here.Enter("CNCPROFILE", "machine-mill.json", "CNCCONNECT", "sim:", "CNCMOTORS", "ON", "CNCJOG", "-123.456,-234.567", "CNCJOG", "Z-", "108.345", "CNCJOG", "X+", "123.456", "CNCJOG", "Y+", "234.567", "CNCZERO", "X", "CNCZERO", "Y");
        var strip = here.Find<Control>("MachineStrip");
        foreach (var name in new[] { "ZText", "MachineHeightText", "OverrideText", "RapidsText", "RapidsSlowerKey", "RapidsFasterKey", "SlowerKey", "FasterKey", "FeedText", "StopKey" })
        {
            var control = here.Find<Control>(name);
            var box = new Rect(control.Bounds.Size).TransformToAABB(control.TransformToVisual(strip)!.Value);
            Assert.True(box is { Width: > 0, Height: > 8 } && new Rect(strip.Bounds.Size).Contains(box), $"{name} at {box}");
        }

        Assert.Equal(("R 100 %", "/ -108.345 mm"), (here.Find<TextBlock>("RapidsText").Text, here.Find<TextBlock>("MachineHeightText").Text));
        Assert.All(strip.GetVisualDescendants().OfType<TextBlock>().Where(text => text.IsEffectivelyVisible && text.Name != "ReasonText"), text => Assert.True(text.Bounds.Width <= ((Control)text.GetVisualParent()!).Bounds.Width + 0.5 && !text.TextLayout.TextLines.Any(line => line.HasCollapsed || line.HasOverflowed), text.Text));
        Assert.Equal("", CutOff(here));
    });

    /// <summary>A long figure is shown smaller; none of its digits is hidden.</summary>
    [Theory]
    [InlineData("-123.456", "-1234.565")]
    [InlineData("-12345.678", "-1234.565")]
    [InlineData("12345.678", "1234.565")]
    public Task In_the_smallest_window_no_digit_of_a_place_is_hidden(string plane, string height) => fixture.WithOperator(here =>
    {
        here.Hands.Resize(new Size(1024, 700));
        here.Enter("CNCPROFILE", "machine-mill.json", "CNCCONNECT", "sim:?speed=max", "CNCMOTORS", "ON", "CNCZERO", "All", "CNCJOG", $"{plane},{plane}", "CNCJOG", height[0] == '-' ? "Z-" : "Z+", height.TrimStart('-'));
        here.Until(() => here.Find<TextBlock>("ZText").Text == height && here.Find<TextBlock>("YText").Text == plane);
        var field = here.Find<Border>("PlaceField");
        var room = new Rect(field.Bounds.Size).Deflate(field.Padding).Inflate(0.5);
        Assert.Equal((plane, $"machine {plane}  {plane} mm", $"/ {height} mm"), (here.Find<TextBlock>("XText").Text, here.Find<TextBlock>("MachinePlaceText").Text, here.Find<TextBlock>("MachineHeightText").Text));
        var boxes = new List<Rect>();
        foreach (var text in field.GetVisualDescendants().OfType<TextBlock>())
        {
            var box = new Rect(text.Bounds.Size).TransformToAABB(text.TransformToVisual(field)!.Value);
            Assert.True(room.Contains(box), $"{text.Text} at {box} in {room}");
            Assert.True(text.Bounds.Width + 0.5 >= text.TextLayout.Width && !text.TextLayout.TextLines.Any(line => line.HasCollapsed || line.HasOverflowed), text.Text);
            Assert.True(text.FontSize * box.Height / text.Bounds.Height >= 7.5, $"{text.Text} is {box.Height / text.Bounds.Height} of its size");
            Assert.DoesNotContain(boxes, other => other.Deflate(0.5).Intersects(box.Deflate(0.5)));
            boxes.Add(box);
        }
    });

    /// <summary>Pages and palettes that were enlarged in a large window take at most the available room, and get their size back when there is
    /// room.</summary>
    [Fact]
    public Task A_smaller_window_takes_from_the_panels_before_the_canvas_is_gone() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(new Size(1900, 1000));
        here.Step();
        var (pages, palettes) = (here.Find<PageTabs>("Pages"), here.Find<PageTabs>("Palettes"));
        var corner = pages.TranslatePoint(new Point(200, -2), here.Window)!.Value;
        here.Hands.Drag(corner, corner.WithY(250));
        var edge = palettes.TranslatePoint(new Point(-2, 60), here.Window)!.Value;
        here.Hands.Drag(edge, edge.WithX(700));
        here.Step();
        var large = (pages.Bounds.Height, palettes.Bounds.Width);
        Assert.True(large is { Item1: > 600, Item2: > 1000 }, $"{large}");
        here.Hands.Resize(new Size(1024, 700));
        here.Step();

        Assert.Equal("", CutOff(here));
        Assert.True(here.Window.Canvas.Bounds is { Width: >= 200, Height: >= 80 }, $"{here.Window.Canvas.Bounds}");
        var line = here.Find<TextBox>("LineBox");
        Assert.True(line.TranslatePoint(new Point(0, line.Bounds.Height), here.Window)!.Value.Y < 690, "the command line is below the window");
        here.Hands.Resize(new Size(1900, 1000));
        here.Step();
        Assert.Equal(large, (pages.Bounds.Height, palettes.Bounds.Width));
    });

    [Fact]
    public Task The_frame_of_the_simulation_moves_nothing() => fixture.WithOperator(here =>
    {
        here.Step();
        var frame = here.Find<Border>("Frame");
        var (before, unlit) = (PlacesOf(), frame.BorderBrush);
        here.Enter("CNCCONNECT", "sim:");

        Assert.Equal(before, PlacesOf());
        Assert.NotEqual(unlit, frame.BorderBrush);

        List<(string?, Point?)> PlacesOf() => [.. new[] { "MainMenu", "StopKey", "ToolColumn", "CanvasPlace", "PlayButton", "Palettes", "Pages", "CoordinateText" }.Select(name => (name, here.Find<Control>(name).TranslatePoint(default, here.Window)))];
    });

    [Fact]
    public Task The_window_has_an_icon() => fixture.WithOperator(here => Assert.NotNull(here.Window.Icon));

    /// <summary>Two starts with the same settings.</summary>
    private async Task InTurn(DirectoryInfo folder, Action<Operator> first, Action<Operator> second)
    {
        await fixture.WithOperator(first, folder.FullName);
        await fixture.WithOperator(second, folder.FullName);
        folder.Delete(recursive: true);
    }

    /// <summary>The tools that are not completely inside their column.</summary>
    private static string CutOff(Operator here)
    {
        var column = here.Find<ItemsControl>("ToolColumn");
        var room = new Rect(column.Bounds.Size);
        return string.Join(", ", column.GetVisualDescendants().OfType<Button>().Where(tool => !room.Contains(new Rect(tool.Bounds.Size).TransformToAABB(tool.TransformToVisual(column)!.Value))).Select(tool => tool.Tag));
    }

    [Fact]
    public Task A_tool_runs_its_command() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("ZOOM", "Scale", "0.1");
        var far = here.Commands.View.Current.Height;
        here.Click(here.Find<ItemsControl>("ToolColumn").GetVisualDescendants().OfType<Button>().First(button => button.DataContext is ToolButton { Command: "ZOOM" }));
        here.WaitUntilIdle();

        Assert.True(here.Commands.View.Current.Height < far / 2);
    });

    [Fact]
    public Task The_wheel_zooms_at_the_cursor() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        var before = here.Commands.View.Current.Height;
        here.Hands.Wheel(here.MiddleOf(here.Window.Canvas), new Vector(0, 1));
        here.Step();

        Assert.True(here.Commands.View.Current.Height < before);
    });

    [Fact]
    public Task A_window_over_everything_selects_all_and_the_properties_name_the_slots() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Show("Properties");
        var canvas = here.Window.Canvas;
        var corner = canvas.TranslatePoint(new Point(4, 4), here.Window)!.Value;
        var opposite = canvas.TranslatePoint(new Point(canvas.Bounds.Width - 4, canvas.Bounds.Height - 4), here.Window)!.Value;
        here.Hands.Drag(corner, opposite);
        here.WaitUntilIdle();

        Assert.Equal(4, here.Commands.Document.Current.Selection.Count);
        Assert.Contains("4", here.Find<TextBlock>("SummaryText").Text, StringComparison.Ordinal);
        var names = here.Find<ListBox>("LineList").Items.Cast<PropertyLine>().Select(line => line.Name).ToList();
        Assert.All(SlotNames.All.Zip(SlotNames.Units), slot => Assert.Contains($"{slot.First} {slot.Second}".TrimEnd(), names));
        Assert.Contains("1 Start X mm", names);
        Assert.Contains("10 Radius mm", names);
        Assert.Contains("15 Sweep deg", names);
    });

    [Fact]
    public Task A_box_to_the_right_takes_what_is_inside_and_to_the_left_what_it_touches() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Until(() => here.Window.Canvas.IsUpToDate);
        var canvas = here.Window.Canvas;
        var middle = here.MiddleOf(canvas);
        var above = new Point(middle.X, canvas.TranslatePoint(new Point(0, 4), here.Window)!.Value.Y);
        var right = new Point(canvas.TranslatePoint(new Point(canvas.Bounds.Width - 4, 0), here.Window)!.Value.X, middle.Y);
        here.Hands.Drag(above, right);
        here.WaitUntilIdle();
        Assert.Empty(here.Commands.Document.Current.Selection);
        here.Hands.Drag(right, above);
        here.WaitUntilIdle();

        Assert.NotEmpty(here.Commands.Document.Current.Selection);
    });

    [Fact]
    public Task The_window_lives_while_a_large_drawing_is_opened() => fixture.WithOperator(here =>
    {
        var file = Path.GetTempFileName();
        using (var dxf = new StreamWriter(file) { NewLine = "\n" })
        {
            dxf.Write("0\nSECTION\n2\nENTITIES\n");
            for (var i = 0; i < 2000; i++) dxf.Write(FormattableString.Invariant($"0\nLINE\n8\n0\n10\n{i}\n20\n0\n11\n{i + 0.5}\n21\n1\n"));
            dxf.Write("0\nENDSEC\n0\nEOF\n");
        }

        using var goOn = new ManualResetEventSlim();
        here.Commands.Progress.Changed += Hold;
        here.Enter("FILEDIA", "0", "OPEN");
        here.Hands.Type(file);
        here.Hands.Press(Key.Enter);
        Assert.True(here.Desk.Queue.IsBusy);
        here.Hands.Type("cncstatus");
        Assert.Equal("cncstatus", here.Window.Model.Command.Line);
        here.Hands.Press(Key.Escape);
        goOn.Set();
        here.WaitUntilIdle();
        here.Commands.Progress.Changed -= Hold;
        File.Delete(file);

        Assert.Contains(here.History, line => line.Contains("Enter name of drawing", StringComparison.Ordinal));
        Assert.False(here.Desk.Queue.IsBusy);

        void Hold(object? sender, EventArgs e) => goOn.Wait(TimeSpan.FromSeconds(60)); // the reader is blocked at its first report until the operator has typed
    });
}
