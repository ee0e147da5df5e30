using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.Options;
using Engraver.TestKit;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Options;

[Collection(DesktopCollection.Name)]
public sealed class OptionsTests(DesktopFixture fixture)
{
    [Theory]
    [InlineData("typed")]
    [InlineData("inside another")]
    public Task OPTIONS_opens_the_sheet_and_the_machine_strip_stays(string how) => fixture.WithOperator(here =>
    {
        if (how == "typed") here.Enter("OPTIONS");
        else here.Enter("DIST", "'OPTIONS");
        here.Until(() => here.Window.Model.Options.IsOpen);
        here.Step();

        Assert.True(here.Find<TextBox>("SearchBox").IsFocused);
        var sheet = here.Find<OptionsView>("OptionsSheet");
        Assert.False(new Rect(sheet.TranslatePoint(default, here.Window)!.Value, sheet.Bounds.Size).Intersects(here.Window.StopArea));
        Assert.Equal(how == "typed" ? null : "DIST", here.Desk.Prompt.Command);
        here.Hands.Press(Key.Escape);
        here.Step();
        Assert.False(here.Window.Model.Options.IsOpen);
        Assert.Equal(how == "typed" ? null : "DIST", here.Desk.Prompt.Command);
    });

    [Fact]
    public Task With_a_dash_it_asks_at_the_command_line() => fixture.WithOperator(here =>
    {
        here.Enter("-OPTIONS");
        Assert.Equal(("OPTIONS", false), (here.Desk.Prompt.Command, here.Window.Model.Options.IsOpen));
        here.Enter("PICKBOX", "9");

        Assert.Equal(9.0, here.Commands.Settings.Current.Variables["PICKBOX"]);
    });

    [Fact]
    public Task Pages_show_the_settings_and_a_search_finds_across_them() => fixture.WithOperator(here =>
    {
        Open(here);
        Assert.Equal(["Drawing", "Toolpath", "Feeds", "Screen and commands", "Drafting aids"], here.Window.Model.Options.Pages);
        here.Hands.Type("wheel");
        here.Step();
        Assert.Equal(["ZOOMFACTOR", "ZOOMWHEEL"], here.Window.Model.Options.Shown.Select(row => row.Entry.Key).Order(StringComparer.Ordinal));
        here.Click(here.Find<ListBox>("OptionPages").GetVisualDescendants().OfType<ListBoxItem>().Single(item => Equals(item.DataContext, "Feeds")));
        here.Step();

        Assert.Equal(["feed", "vector-speed", "rapid", "acceleration"], here.Window.Model.Options.Shown.Select(row => row.Entry.Key));
        Assert.Equal("", here.Window.Model.Options.Search);
    });

    [Fact]
    public Task OK_takes_by_the_commands_so_that_UNDO_takes_it_back() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        Open(here);
        Field<TextBox>(here, "max-error").Text = "0.02";
        Show(here, "Toolpath");
        Choose(here, "order", "Drawn");
        Show(here, "Drafting aids");
        Field<CheckBox>(here, "ORTHOMODE").IsChecked = true;
        here.Click(here.Find<Button>("OptionsTake"));
        here.Until(() => !here.Window.Model.Options.IsOpen);
        here.WaitUntilIdle();

        Assert.Equal((0.02, "Drawn", true), (here.Commands.Document.Current.Settings.MaxErrorMm, here.Commands.Document.Current.Settings.Order.ToString(), here.Commands.View.Current.Ortho));
        Assert.Contains(here.History, line => line.Contains("CNCMAXERR", StringComparison.Ordinal));
        here.Enter("U", "U");
        Assert.NotEqual(0.02, here.Commands.Document.Current.Settings.MaxErrorMm);
    });

    [Fact]
    public Task A_wrong_value_is_told_beside_its_field_and_nothing_is_taken() => fixture.WithOperator(here =>
    {
        Open(here);
        Field<TextBox>(here, "max-error").Text = "-3";
        here.Step();
        Assert.Contains(here.Find<OptionsView>("OptionsSheet").GetVisualDescendants().OfType<TextBlock>(), text => text is { IsEffectivelyVisible: true } && text.Text?.Contains("-3 is out of range", StringComparison.Ordinal) == true);
        Show(here, "Toolpath");
        Choose(here, "order", "Drawn");
        here.Click(here.Find<Button>("OptionsApply"));
        here.WaitUntilIdle();

        Assert.True(here.Window.Model.Options.IsOpen);
        Assert.Equal("Drawing", here.Window.Model.Options.Page); // the page of the invalid value
        Assert.Equal("Nearest", here.Commands.Document.Current.Settings.Order.ToString());
        here.Click(here.Find<Button>("OptionsCancel"));
        Assert.False(here.Window.Model.Options.IsOpen);
    });

    [Fact]
    public Task What_a_command_refuses_is_told_beside_the_setting() => fixture.WithOperator(here =>
    {
        Open(here, "Toolpath");
        Choose(here, "kerf", "Outside"); // without a diameter
        here.Click(here.Find<Button>("OptionsTake"));
        here.Until(() => Row(here, "kerf").HasError);
        here.WaitUntilIdle();
        Assert.Null(here.Desk.Prompt.Command);
        Field<TextBox>(here, "tool-diameter").Text = "3";
        here.Click(here.Find<Button>("OptionsTake"));
        here.Until(() => !here.Window.Model.Options.IsOpen);

        Assert.Equal(("Outside", 3.0), (here.Commands.Document.Current.Settings.Kerf.ToString(), here.Commands.Document.Current.Settings.ToolDiameterMm));
    });

    [Fact]
    public Task While_a_job_runs_it_opens_and_what_belongs_to_the_job_is_refused() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", SlowSimulator.Address, "CNCARM", "Stream");
        here.Click(here.Find<Button>("StartKey"));
        here.Until(() => here.Commands.Machine.Status.State == MachineState.Running);
        _ = here.Desk.Queue.RunAsync("OPTIONS");
        here.Until(() => here.Window.Model.Options.IsOpen);
        here.Step();
        Show(here, "Feeds");
        Field<TextBox>(here, "feed").Text = "77";
        here.Click(here.Find<Button>("OptionsApply"));
        here.Until(() => Row(here, "feed").HasError);
        Assert.StartsWith("CNCFEED can change the drawing", Row(here, "feed").Error, StringComparison.Ordinal);
        Assert.True(here.Commands.Machine.IsRunning);
        here.Hands.Press(Key.Pause);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
    });

    /// <summary>Toggling a check box of a sheet moves nothing: Tab reaches it, its focus is visible, and Space toggles it.</summary>
    [Fact]
    public Task Check_boxes_and_pages_are_worked_by_keyboard_alone() => fixture.WithOperator(here =>
    {
        Open(here, "Drafting aids");
        var box = Field<CheckBox>(here, "GRIDMODE");
        for (var presses = 0; presses < 40 && !box.IsFocused; presses++) Press(here, Key.Tab);
        Assert.True(box.IsFocused, "Tab does not reach the check box");
        Assert.True(((IPseudoClasses)box.Classes).Contains(":focus-visible"), "that it has the keyboard is not seen");
        var before = box.IsChecked;
        Press(here, Key.Space);
        Assert.Equal(!before, box.IsChecked);
        for (var presses = 0; presses < 40 && here.Window.FocusManager?.GetFocusedElement() is not ListBoxItem; presses++) Press(here, Key.Tab);
        var (pages, page) = (here.Window.Model.Options.Pages.ToList(), here.Window.Model.Options.Page!);
        Press(here, Key.Up);
        Assert.Equal(pages[pages.IndexOf(page) - 1], here.Window.Model.Options.Page);
        for (var presses = 0; presses < 40 && here.Window.FocusManager?.GetFocusedElement() is not CheckBox; presses++) Press(here, Key.Tab);
        Press(here, Key.Enter);
        here.Until(() => !here.Window.Model.Options.IsOpen);
        here.WaitUntilIdle();

        Assert.Equal(!before, here.Commands.View.Current.Grid);
    });

    /// <summary>Typed and stored values stay English; displayed texts are German.</summary>
    [Fact]
    public Task Choices_are_shown_in_German_and_kept_in_English() => fixture.WithOperator(here =>
    {
        here.Enter("OPTIONS");
        here.Until(() => here.Window.Model.Options.IsOpen);
        Show(here, here.Window.Model.Options.Pages[1]);
        var order = Field<ComboBox>(here, "order");
        Assert.Contains("Nächste", order.GetVisualDescendants().OfType<TextBlock>().Select(text => text.Text));
        Assert.Contains("Gezeichnet", Row(here, "order").Entry.DisplayChoices.Select(choice => choice.Word));
        Assert.Contains("Aus", Row(here, "kerf").Entry.DisplayChoices.Select(choice => choice.Word));
        Assert.Contains("Nächste", Row(here, "order").Meaning, StringComparison.Ordinal);
        Choose(here, "order", "Drawn");
        here.Click(here.Find<Button>("OptionsTake"));
        here.Until(() => !here.Window.Model.Options.IsOpen);
        here.WaitUntilIdle();

        Assert.Equal("Drawn", here.Commands.Document.Current.Settings.Order.ToString());
    }, language: new CultureInfo("de"));

    private static void Choose(Operator here, string key, string value) => Field<ComboBox>(here, key).SelectedItem = Row(here, key).Choices.Single(choice => choice.Value == value);

    private static void Press(Operator here, Key key)
    {
        if (key == Key.Space) here.Hands.Type(" ");
        else here.Hands.Press(key);
        here.Step();
    }

    private static void Open(Operator here, string? page = null)
    {
        here.Enter("OPTIONS");
        here.Until(() => here.Window.Model.Options.IsOpen);
        here.Step();
        if (page is not null) Show(here, page);
    }

    private static void Show(Operator here, string page)
    {
        here.Window.Model.Options.Page = page;
        here.Step();
    }

    private static OptionRow Row(Operator here, string key) => here.Window.Model.Options.Shown.Single(row => row.Entry.Key == key);

    private static T Field<T>(Operator here, string key)
        where T : Control => here.Find<ItemsControl>("SettingList").GetVisualDescendants().OfType<T>().Single(field => Equals(field.Tag, key) && field.IsVisible);
}
