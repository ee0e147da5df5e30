using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.HandMoves;
using Engraver.App.Tabs;
using Engraver.App.Terminals;
using Engraver.Core.Geometry;

namespace Engraver.App.Tests.Shell;

/// <summary>The destination of keys: the command line, unless a field or the terminal has the focus; Esc and Tab always lead back.</summary>
[Collection(DesktopCollection.Name)]
public sealed class KeyboardTests(DesktopFixture fixture)
{
    private static readonly string[] s_palettes = ["Layers", "Properties", "Contours", "Job", "Program", "Machine", "Commissioning", "Plots"];
    private static readonly string[] s_pages = ["Command", "Table", "Trajectories", "Findings", "Alarms", "History", "Terminal"];

    [Fact]
    public Task However_often_Tab_is_pressed_what_is_typed_arrives_in_the_command_line_or_in_a_field_that_is_seen() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        foreach (var page in s_palettes.Concat(s_pages))
        {
            here.Show(page);
            for (var presses = 0; presses < 12; presses++)
            {
                here.Hands.Press(Key.Tab, presses % 3 == 0 ? RawInputModifiers.Shift : RawInputModifiers.None);
                var before = Text(here);
                here.Hands.Type("x");
                Assert.True(Text(here) == before + 1, $"{page}, Tab {presses + 1}: the letter arrived nowhere");
            }

            here.Hands.Press(Key.Escape);
            here.WaitUntilIdle();
            here.Hands.Type("y");
            Assert.Equal("y", here.Window.Model.Command.Line);
            here.Hands.Press(Key.Escape);
            here.WaitUntilIdle();
        }
    });

    [Theory]
    [InlineData(Key.N, RawInputModifiers.Control, "NEW")]
    [InlineData(Key.O, RawInputModifiers.Control, "OPEN")]
    [InlineData(Key.P, RawInputModifiers.Control, "PLOT")]
    [InlineData(Key.S, RawInputModifiers.Control, "QSAVE")]
    [InlineData(Key.S, RawInputModifiers.Control | RawInputModifiers.Shift, "SAVEAS")]
    public Task Control_and_a_letter_run_what_AutoCAD_runs(Key key, RawInputModifiers with, string command) => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Hands.Press(key, with);
        here.WaitUntilIdle();

        Assert.Contains("Command: " + command, here.History);
    });

    [Fact]
    public Task A_key_closes_the_tip_that_would_lie_over_what_it_opens() => fixture.WithOperator(here =>
    {
        var arm = here.Find<Button>("ArmKey");
        ToolTip.SetIsOpen(arm, true);
        here.WaitUntilIdle();
        Assert.True(ToolTip.GetIsOpen(arm));
        here.Hands.Press(Key.F8);

        Assert.False(ToolTip.GetIsOpen(arm));
        Assert.Equal(PlacementMode.BottomEdgeAlignedRight, ToolTip.GetPlacement(arm)); // STOP is to the right of it
    });

    [Theory]
    [InlineData(Key.Enter)]
    [InlineData(Key.Space)]
    public Task A_button_that_was_clicked_is_not_pressed_by_Enter_or_Space(Key key) => fixture.WithOperator(here =>
    {
        var button = here.Find<PageTabs>("Palettes").GetVisualDescendants().OfType<Button>().First(one => one.Name == "FoldButton");
        here.Click(button);
        Assert.Contains("palettes", here.Commands.Settings.Current.FoldedPanels);
        var presses = 0;
        button.Click += (_, _) => presses++;
        if (key == Key.Space) here.Hands.Type(" ");
        else here.Hands.Press(key);
        here.WaitUntilIdle();

        Assert.Equal((0, ""), (presses, here.Window.Model.Command.Line));
        here.Click(button);
        Assert.Equal(1, presses);
    });

    [Fact]
    public Task Typing_while_the_terminal_is_in_front_goes_there_and_Escape_gives_the_keyboard_back() => fixture.WithOperator(here =>
    {
        here.Enter("CNCCONNECT", "sim:");
        here.Show("Terminal");
        here.Hands.Type("MG 2+");
        here.Click(here.Window.Canvas);
        here.Hands.Type("3");
        Assert.Equal(("", "MG 2+3"), (here.Window.Model.Command.Line, Terminal(here).Line));
        here.Hands.Press(Key.Enter);
        here.Until(() => here.Commands.Machine.Connection.Terminal.Lines.Any(line => line.Text.Contains("5.0000", StringComparison.Ordinal)));

        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
        Assert.Equal("Command", here.Find<PageTabs>("Pages").Current!.Key);
        here.Hands.Type("dist");
        Assert.Equal(("dist", ""), (here.Window.Model.Command.Line, Terminal(here).Line));
    });

    /// <summary>Answers to a command are typed to it, wherever the terminal is.</summary>
    [Fact]
    public Task An_answer_does_not_go_to_the_terminal() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Show("Terminal");
        _ = here.Desk.Queue.RunAsync("DIST");
        here.WaitUntilIdle();
        here.Click(here.Window.Canvas);
        here.Hands.Type("4,5");

        Assert.Equal("4,5", here.Window.Model.Command.Line);
    });

    [Theory]
    [InlineData("FileSheet")]
    [InlineData("ConnectSheet")]
    [InlineData("OptionsSheet")]
    public Task Tab_stays_on_a_sheet_that_is_open(string name) => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Show("Machine");
        Open(here, name);
        var sheet = here.Find<UserControl>(name);
        here.Until(() => sheet.IsVisible);
        for (var presses = 0; presses < 40; presses++)
        {
            here.Hands.Press(Key.Tab, presses % 5 == 4 ? RawInputModifiers.Shift : RawInputModifiers.None);
            here.Step();
            if (here.Window.FocusManager?.GetFocusedElement() is Visual focused and not Window) Assert.True(sheet.IsVisualAncestorOf(focused), $"Tab {presses + 1} led to {focused}");
        }
    });

    /// <summary>The pad had the focus before: an arrow key goes to the visible list and moves no machine.</summary>
    [Fact]
    public Task No_key_behind_a_sheet_jogs_the_machine() => fixture.WithOperator(here =>
    {
        here.Enter("CNCCONNECT", "sim:");
        here.Show("Machine");
        here.Find<JogPad>("Pad").Focus();
        Assert.True(here.Find<JogPad>("Pad").IsFocused);
        _ = here.Desk.Queue.RunAsync("OPEN");
        here.Until(() => here.Find<UserControl>("FileSheet").IsVisible);
        here.WaitUntilIdle();
        here.Hands.KeyDown(Key.Left);
        here.Step();
        here.Hands.KeyUp(Key.Left);
        here.WaitUntilIdle();

        Assert.False(here.Commands.Machine.IsRunning);
        Assert.DoesNotContain(here.History, line => line.Contains("CNCJOG", StringComparison.Ordinal));
        Assert.Equal(new Point2D(0, 0), here.Commands.Machine.Status.MachinePosition ?? new Point2D(0, 0));
    });

    private static void Open(Operator here, string sheet)
    {
        if (sheet == "FileSheet") here.Enter("OPEN");
        else if (sheet == "OptionsSheet") here.Enter("OPTIONS");
        else here.Window.Model.Connect.Open();
        here.WaitUntilIdle();
    }

    private static TerminalModel Terminal(Operator here) => (TerminalModel)here.Find<PageTabs>("Pages").Pages.Single(page => page.Key == "Terminal").Page.DataContext!;

    /// <summary>Text in the command line and in all visible fields.</summary>
    private static int Text(Operator here)
    {
        var fields = here.Window.GetVisualDescendants().OfType<TextBox>().Where(box => box.IsEffectivelyVisible && box.Name != "LineBox").Sum(box => box.Text?.Length ?? 0);
        var terminal = here.Find<PageTabs>("Pages").Current?.Key == "Terminal" ? Terminal(here).Line.Length : 0;
        return fields + terminal + here.Window.Model.Command.Line.Length;
    }
}
