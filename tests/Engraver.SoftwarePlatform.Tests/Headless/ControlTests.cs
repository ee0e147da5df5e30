using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;

namespace Engraver.SoftwarePlatform.Tests.Headless;

[Collection(DesktopCollection.Name)]
public sealed class ControlTests(DesktopFixture fixture)
{
    private static readonly TimeSpan Timeout = TimeSpan.FromSeconds(60);

    [Fact]
    public Task A_click_presses_a_button() => fixture.WithDemo((demo, hands) =>
    {
        hands.Click(demo.Middle(demo.Counter));
        hands.Click(demo.Middle(demo.Counter));

        Assert.Equal(2, demo.Presses);
        Assert.Equal("Pressed 2", demo.Counter.Content);
    });

    [Fact]
    public Task Typed_text_arrives_letter_for_letter() => fixture.WithDemo((demo, hands) =>
    {
        hands.Click(demo.Middle(demo.Entry));
        hands.Type("Feed 12,5 mm/s größer ✓");

        Assert.Equal("Feed 12,5 mm/s größer ✓", demo.Entry.Text);
    });

    [Fact]
    public Task Shift_and_control_with_an_arrow_select_a_word() => fixture.WithDemo((demo, hands) =>
    {
        hands.Click(demo.Middle(demo.Entry));
        hands.Type("hello world");
        hands.Press(Key.Home);
        hands.Press(Key.Right, RawInputModifiers.Shift | RawInputModifiers.Control);

        Assert.Equal("hello", demo.Entry.SelectedText.Trim());
    });

    [Fact]
    public Task Control_c_and_control_v_go_through_the_clipboard() => fixture.WithDemo((demo, hands) =>
    {
        hands.Click(demo.Middle(demo.Entry));
        hands.Type("abc");
        hands.Press(Key.A, RawInputModifiers.Control);
        hands.Press(Key.C, RawInputModifiers.Control);
        Assert.Equal("abc", fixture.Desktop.ClipboardText);

        fixture.Desktop.ClipboardText = "from elsewhere";
        hands.Press(Key.A, RawInputModifiers.Control);
        hands.Press(Key.V, RawInputModifiers.Control);

        Assert.Equal("from elsewhere", demo.Entry.Text);
    });

    [Fact]
    public Task A_double_click_selects_the_word_under_it() => fixture.WithDemo((demo, hands) =>
    {
        hands.Click(demo.Middle(demo.Entry));
        hands.Type("hello");
        hands.DoubleClick(demo.Entry.TranslatePoint(new Point(24, 16), demo)!.Value);

        Assert.Equal("hello", demo.Entry.SelectedText);
    });

    [Fact]
    public Task A_combo_box_is_worked_by_keyboard() => fixture.WithDemo((demo, hands) =>
    {
        hands.Click(demo.Middle(demo.Choice));
        Assert.True(demo.Choice.IsDropDownOpen);
        fixture.Desktop.Step();
        hands.Press(Key.Down);
        hands.Press(Key.Enter);

        Assert.False(demo.Choice.IsDropDownOpen);
        Assert.Equal(1, demo.Choice.SelectedIndex);
    });

    [Fact]
    public Task A_menu_opens_by_click_and_closes_by_escape() => fixture.WithDemo((demo, hands) =>
    {
        hands.Click(demo.Middle(demo.File));
        Assert.True(demo.File.IsSubMenuOpen);

        hands.Press(Key.Escape);
        Assert.False(demo.File.IsSubMenuOpen);
    });

    [Fact]
    public Task A_tip_appears_when_the_pointer_rests() => fixture.WithDemo((demo, hands) =>
    {
        hands.MovePointer(demo.Middle(demo.Counter));
        fixture.Desktop.StepUntil(() => ToolTip.GetIsOpen(demo.Counter), Timeout);

        hands.MovePointer(new Point(790, 510));
        Assert.False(ToolTip.GetIsOpen(demo.Counter));
    });

    [Fact]
    public Task A_slider_follows_a_drag() => fixture.WithDemo((demo, hands) =>
    {
        var thumb = demo.Feed.GetVisualDescendants().OfType<Avalonia.Controls.Primitives.Thumb>().First();
        var from = demo.Middle(thumb);
        hands.Drag(from, from + new Point(100, 0));

        Assert.InRange(demo.Feed.Value, 25, 45);
    });

    [Fact]
    public Task The_wheel_scrolls_towards_the_end() => fixture.WithDemo((demo, hands) =>
    {
        var scroll = demo.Rows.GetVisualDescendants().OfType<ScrollViewer>().First();
        hands.Wheel(demo.Middle(demo.Rows), new Vector(0, -3));
        Assert.True(scroll.Offset.Y > 0, $"offset {scroll.Offset}");

        hands.Wheel(demo.Middle(demo.Rows), new Vector(0, 30));
        Assert.Equal(0, scroll.Offset.Y);
    });

    [Fact]
    public Task Files_are_dropped_with_their_paths() => fixture.WithDemo((demo, hands) =>
    {
        IReadOnlyList<string> dropped = [];
        DragDrop.AddDropHandler(demo, (_, e) => dropped = [.. e.DataTransfer.TryGetFiles()!.Select(file => file.Path.LocalPath)]);
        var effects = hands.DropFiles(new Point(400, 400), ["/tmp/one drawing.dxf", "/tmp/größe#1.dxf"]);

        Assert.Equal(["/tmp/one drawing.dxf", "/tmp/größe#1.dxf"], dropped);
        Assert.Equal(DragDropEffects.Copy, effects);
    });
}
