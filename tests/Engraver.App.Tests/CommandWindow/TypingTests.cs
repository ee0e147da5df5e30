using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.CommandWindow;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Tests.CommandWindow;

[Collection(DesktopCollection.Name)]
public sealed class TypingTests(DesktopFixture fixture)
{
    [Fact]
    public Task Typing_needs_no_click_into_the_command_line() => fixture.WithOperator(here =>
    {
        Assert.IsNotType<TextBox>(here.Window.FocusManager?.GetFocusedElement());
        here.Hands.Type("dist");

        Assert.Equal("dist", here.Window.Model.Command.Line);
    });

    [Fact]
    public Task The_last_line_of_the_history_is_seen_however_large_the_history_is() => fixture.WithOperator(here =>
    {
        for (var i = 0; i < 12; i++) here.Enter("CNCSTATUS");
        var list = here.Find<ListBox>("HistoryList");
        foreach (var way in new[] { "as it is", "F2", "back" })
        {
            if (way != "as it is") here.Hands.Press(Key.F2);
            here.WaitUntilIdle();
            var last = list.ContainerFromIndex(list.ItemCount - 1);
            var bottom = last?.TranslatePoint(new Point(0, last.Bounds.Height), list)?.Y ?? double.PositiveInfinity;
            Assert.True(bottom <= list.Bounds.Height + 0.5, FormattableString.Invariant($"{way}: {bottom} of {list.Bounds.Height}"));
        }
    });

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public Task Pasted_lines_are_all_taken_and_what_follows_the_last_stays_to_be_typed_on(bool inTheLine) => fixture.WithOperator(here =>
    {
        if (inTheLine) here.Hands.Type("op");
        fixture.Desktop.ClipboardText = (inTheLine ? "en" : "open") + " paper-001.dxf\r\nzoom e\r\nlist 4 d";
        here.Hands.Press(Key.V, RawInputModifiers.Control);
        here.Until(() => here.Window.Model.Command.Line == "list 4 d");
        here.WaitUntilIdle();

        Assert.Equal(4, here.Commands.Document.Current.Drawing!.Entities.Count);
        Assert.Contains(here.History, line => line.EndsWith(" zoom", StringComparison.Ordinal));
    });

    [Fact]
    public Task One_pasted_line_with_its_end_is_still_one_answer() => fixture.WithOperator(here =>
    {
        here.Enter("FILEDIA", "0", "open");
        fixture.Desktop.ClipboardText = "no such drawing.dxf\n";
        here.Hands.Press(Key.V, RawInputModifiers.Control);
        here.Until(() => here.Window.Model.Command.Line.Length > 0);

        Assert.Equal("no such drawing.dxf", here.Window.Model.Command.Line);
        Assert.Equal("OPEN", here.Desk.Prompt.Command);
    });

    [Fact]
    public Task One_pasted_line_goes_where_the_caret_is() => fixture.WithOperator(here =>
    {
        here.Hands.Type("opn");
        here.Hands.Press(Key.Left);
        fixture.Desktop.ClipboardText = "e";
        here.Hands.Press(Key.V, RawInputModifiers.Control);
        here.Until(() => here.Window.Model.Command.Line.Length == 4);

        Assert.Equal("open", here.Window.Model.Command.Line);
    });

    [Fact]
    public Task Space_is_enter_until_an_answer_may_hold_spaces() => fixture.WithOperator(here =>
    {
        here.Enter("FILEDIA", "0");
        here.Hands.Type("open ");
        here.WaitUntilIdle();
        Assert.Equal("OPEN", here.Desk.Prompt.Command);

        here.Hands.Type("no such drawing.dxf");

        Assert.Equal("no such drawing.dxf", here.Window.Model.Command.Line);
    });

    [Fact]
    public Task Enter_alone_repeats_the_last_command() => fixture.WithOperator(here =>
    {
        here.Enter("CNCSTATUS");
        here.Enter("");

        Assert.Equal(2, here.History.Count(line => line == "OFFLINE"));
    });

    [Fact]
    public Task The_arrow_keys_walk_through_what_was_typed() => fixture.WithOperator(here =>
    {
        here.Enter("CNCSTATUS", "CNCSTOP");
        here.Hands.Type("x");
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
        here.Hands.Press(Key.Up);
        here.Hands.Press(Key.Up);
        Assert.Equal("CNCSTATUS", here.Window.Model.Command.Line);
        here.Hands.Press(Key.Down);

        Assert.Equal("CNCSTOP", here.Window.Model.Command.Line);
    });

    [Fact]
    public Task Suggestions_say_the_alias_first_and_tab_takes_one() => fixture.WithOperator(here =>
    {
        here.Hands.Type("m");
        Assert.Equal("M (MOVE)", here.Window.Model.Command.Suggestions[0].Text);
        Assert.True(here.Find<TextBlock>("PromptText").IsEffectivelyVisible);
        here.Hands.Press(Key.Tab);

        Assert.Equal("MOVE", here.Window.Model.Command.Line);
    });

    [Fact]
    public Task A_suggestion_is_chosen_with_the_arrow_and_enter() => fixture.WithOperator(here =>
    {
        here.Hands.Type("cncsta");
        here.Hands.Press(Key.Down);
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();

        Assert.Contains("OFFLINE", here.History);
    });

    [Fact]
    public Task A_click_on_an_option_is_an_answer() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("CNCORDER");
        var drawn = here.Find<PromptOptions>("OptionList").GetVisualDescendants().OfType<Button>().Single(button => button.DataContext is Keyword { Name: "Drawn" });
        here.Click(drawn);
        here.WaitUntilIdle();

        Assert.Equal("Drawn", here.Commands.Document.Current.Settings.Order.ToString());
        Assert.Null(here.Desk.Prompt.Command);
    });

    [Fact]
    public Task Escape_ends_what_asks() => fixture.WithOperator(here =>
    {
        here.Enter("OPEN");
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();

        Assert.Null(here.Desk.Prompt.Command);
        Assert.Contains("*Cancel*", here.History);
    });

    [Fact]
    public Task A_transparent_command_runs_inside_another() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("MOVE", "'CNCSTATUS");

        Assert.Contains("OFFLINE", here.History);
        Assert.Equal("MOVE", here.Desk.Prompt.Command);
    });

    [Fact]
    public Task A_suggested_command_runs_inside_another_too() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("MOVE");
        here.Hands.Type("'cncstat");
        here.Hands.Press(Key.Tab);
        Assert.Equal("'CNCSTATUS", here.Window.Model.Command.Line);
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();

        Assert.Contains("OFFLINE", here.History);
        Assert.Equal("MOVE", here.Desk.Prompt.Command);
    });

    [Fact]
    public Task F2_gives_the_history_room_and_takes_it_back() => fixture.WithOperator(here =>
    {
        var before = here.Find<ListBox>("HistoryList").Bounds.Height;
        here.Hands.Press(Key.F2);
        here.Step();
        var expanded = here.Find<ListBox>("HistoryList").Bounds.Height;
        here.Hands.Press(Key.F2);
        here.Step();

        Assert.True(expanded > before + 150, $"{before} to {expanded}");
        Assert.Equal(before, here.Find<ListBox>("HistoryList").Bounds.Height);
    });

    [Fact]
    public Task A_script_is_run_from_the_command_line() => fixture.WithOperator(here =>
    {
        here.Enter("SCRIPT", "first-job.scr");
        here.WaitUntilIdle();

        Assert.NotNull(here.Commands.Document.Current.Drawing);
    });
}
