using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;

namespace Engraver.App.Tests.Menus;

[Collection(DesktopCollection.Name)]
public sealed class CanvasMenuTests(DesktopFixture fixture)
{
    [Fact]
    public Task With_nothing_selected_it_repeats_and_shows_the_view() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("ZOOM", "E");
        var shown = Open(here);

        Assert.Equal(["CanvasMenu.Repeat", "CanvasMenu.Recent", "ZOOM"], shown.Select(item => item.Tag).Take(3));
        Assert.DoesNotContain(shown, item => item.Tag is "ERASE");
        Assert.Equal("Repeat ZOOM", shown[0].Header);
        Assert.Equal(["E", "ZOOM", "OPEN"], shown[1].Items.OfType<MenuItem>().Select(item => item.Tag));
        here.Click(shown[0]);
        here.WaitUntilIdle();
        Assert.Equal("ZOOM", here.Desk.Prompt.Command);
    });

    [Fact]
    public Task With_objects_selected_it_edits_them() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("SELECT", "ALL", "");
        var shown = Open(here);
        here.Click(shown.Single(item => item.Tag is "ERASE"));
        here.WaitUntilIdle();

        Assert.Equal(0, here.Commands.Document.Current.Drawing!.Entities.Count);
    });

    [Fact]
    public Task In_a_command_it_has_enter_cancel_and_the_options() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("ZOOM");
        var shown = Open(here);

        Assert.Equal(["CanvasMenu.Enter", "CanvasMenu.Cancel"], shown.Select(item => item.Tag).Take(2));
        Assert.Equal(here.Desk.Prompt.Options.Select(option => option.Name), shown.Skip(3).Select(item => item.Tag));
        here.Click(shown.Single(item => item.Tag is "Extents"));
        here.WaitUntilIdle();
        Assert.Null(here.Desk.Prompt.Command);
        here.Enter("ZOOM");
        here.Click(Open(here)[1]);
        here.WaitUntilIdle();
        Assert.Null(here.Desk.Prompt.Command);
    });

    /// <summary>As in AutoCAD the right button ends a selection.</summary>
    [Fact]
    public Task Where_objects_are_asked_for_the_right_button_is_enter() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("ERASE", "L");
        here.Hands.Click(here.MiddleOf(here.Window.Canvas), MouseButton.Right);
        here.WaitUntilIdle();

        Assert.Equal(3, here.Commands.Document.Current.Drawing!.Entities.Count);
    });

    [Fact]
    public Task What_starts_motion_is_neither_repeated_nor_recent() => fixture.WithOperator(here =>
    {
        here.Enter("CNCCONNECT", "sim:", "CNCHOME");
        var shown = Open(here);

        Assert.DoesNotContain(shown, item => item.Tag is "CanvasMenu.Repeat");
        Assert.Equal(["sim:", "CNCCONNECT"], shown.Single(item => item.Tag is "CanvasMenu.Recent").Items.OfType<MenuItem>().Select(item => item.Tag));
        here.Hands.Press(Key.Escape);
        here.Step();
    });

    private static List<MenuItem> Open(Operator here)
    {
        here.Hands.Click(here.MiddleOf(here.Window.Canvas), MouseButton.Right);
        here.Step();
        return [.. here.Window.GetVisualDescendants().OfType<MenuItem>().Where(item => item.IsEffectivelyVisible && item.Parent is ContextMenu)];
    }
}
