using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Documents;

namespace Engraver.App.Tests.Editing;

/// <summary>Selecting and editing with the mouse in the real window: a line (A1, 0,0 to 100,0), an arc (A2, around 50,50, radius 20, 0 to 90 degrees), a
/// circle (A3, 150,50, radius 20), a square (A4, from 0,100, side 40).</summary>
[Collection(DesktopCollection.Name)]
public sealed class EditingByHandTests(DesktopFixture fixture)
{
    [Fact]
    public Task What_is_picked_for_a_command_lights_up_at_once_and_Shift_puts_it_out() => With(here =>
    {
        here.Enter("MOVE");
        Click(here, 30, 0);
        Assert.Equal([0], Highlighted(here));
        Click(here, 170, 50);
        Assert.Equal([0, 2], Highlighted(here));
        Click(here, 30, 0, RawInputModifiers.Shift);
        Assert.Equal([2], Highlighted(here));
        Assert.StartsWith("Select objects", here.Commands.Prompt.Text, StringComparison.Ordinal);
        Click(here, 30, 0);
        Assert.Equal([2, 0], Highlighted(here));
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
        Assert.Equal([], Highlighted(here));
    });

    [Fact]
    public Task A_box_is_dragged_at_select_objects_and_with_Shift_it_removes() => With(here =>
    {
        here.Enter("ERASE");
        Drag(here, (-20, -20), (190, 90));
        Assert.Equal([0, 1, 2], Highlighted(here));
        Click(here, 190, 90, RawInputModifiers.Shift);
        Click(here, 110, 20);
        Assert.Equal([0, 1], Highlighted(here));
        Assert.StartsWith("Select objects", here.Commands.Prompt.Text, StringComparison.Ordinal);
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();
        Assert.Equal(2, Drawn(here).Entities.Count);
    });

    [Fact]
    public Task A_move_shows_the_object_at_the_cursor_before_the_click() => With(here =>
    {
        here.Enter("MOVE", "H", "A3", "", "150,50");
        Point(here, 130, 80);
        here.Until(() => here.Window.Canvas.Pointing.Ghost.Count == 1);
        var ghost = here.Window.Canvas.Pointing.Ghost[0].Arc;
        Assert.True(ghost.Centre.DistanceTo(new Point2D(130, 80)) < 1.0);
        Assert.Equal(new Point2D(150, 50), Only(here, 2).Arc.Centre);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
        here.Until(() => here.Window.Canvas.Pointing.Ghost.Count == 0);
    });

    [Fact]
    public Task A_grip_is_dragged_with_the_button_down_and_snaps() => With(here =>
    {
        Click(here, 30, 0);
        Drag(here, (100, 0), (50.4, 70.3));
        Assert.Equal((new Point2D(0, 0), new Point2D(50, 70)), Ends(here, 0)); // END of the arc
        Assert.Equal([0], here.Commands.Document.Current.Selection);
        Assert.Null(here.Commands.Prompt.Command);
        here.Enter("U");
        Assert.Equal(new Point2D(100, 0), Ends(here, 0).End);
    });

    /// <summary>Faster than the command can prompt: the point is kept for it.</summary>
    [Fact]
    public Task A_grip_that_is_dragged_in_a_flash_lands_where_it_was_let_go() => With(here =>
    {
        Click(here, 30, 0);
        here.Hands.Drag(At(here, 100, 0), At(here, 50.4, 70.3));
        here.WaitUntilIdle();
        Assert.Equal((new Point2D(0, 0), new Point2D(50, 70)), Ends(here, 0));
    });

    [Fact]
    public Task A_grip_is_clicked_moved_and_clicked_with_ortho() => With(here =>
    {
        here.Hands.Press(Key.F8);
        here.WaitUntilIdle();
        Click(here, 30, 0);
        Click(here, 50, 0);
        Assert.Equal("GRIPEDIT", here.Commands.Prompt.Command);
        Point(here, 53, -40);
        here.Until(() => here.Window.Canvas.Pointing.Ghost.Count == 1);
        Click(here, 53, -40);
        Assert.Equal(50.0, (Ends(here, 0).Start.X + Ends(here, 0).End.X) / 2.0, 1e-9);
        Assert.InRange(Ends(here, 0).Start.Y, -41.0, -39.0);
    });

    [Fact]
    public Task A_grip_takes_a_typed_place_and_Esc_leaves_all_as_it_was() => With(here =>
    {
        Click(here, 170, 50);
        Click(here, 150, 70);
        here.Enter("@0,10");
        Assert.Equal(30.0, Only(here, 2).Arc.Radius, 1e-9);
        Click(here, 150, 50);
        Point(here, 160, 60);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
        Assert.Equal((new Point2D(150, 50), 30.0), (Only(here, 2).Arc.Centre, Math.Round(Only(here, 2).Arc.Radius, 9)));
        Assert.Equal([], here.Commands.Document.Current.Selection);
    });

    [Fact]
    public Task A_vertex_of_a_polyline_is_dragged() => With(here =>
    {
        Click(here, 20, 100);
        Drag(here, (0, 100), (-10, 90.2));
        var corner = DrawingPick.Segments(Drawn(here), 3).First().Start;
        Assert.True(corner.DistanceTo(new Point2D(-10, 90.2)) < 0.7);
        Assert.Equal(corner, DrawingPick.Segments(Drawn(here), 3).Last().End);
    });

    [Fact]
    public Task Copies_are_clicked_until_Enter() => With(here =>
    {
        here.Enter("COPY", "H", "A3", "", "150,50");
        Click(here, 150, 100);
        Click(here, 100, 100);
        Assert.Equal([2], Highlighted(here));
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();
        Assert.Equal((6, null), (Drawn(here).Entities.Count, here.Commands.Prompt.Command));
        here.Enter("U");
        Assert.Equal(4, Drawn(here).Entities.Count);
    });

    /// <summary>The cursor stays on the circle while it is erased and restored.</summary>
    [Fact]
    public Task Hover_goes_with_what_is_erased() => With(here =>
    {
        Click(here, 170, 50);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
        Point(here, 170, 50);
        Assert.Equal(2, here.Window.Canvas.Pointing.Hovered);
        here.Enter("ERASE", "H", "A3", "");
        Assert.Null(here.Window.Canvas.Pointing.Hovered);
        here.Enter("U");
        Assert.Equal(2, here.Window.Canvas.Pointing.Hovered);
        here.Enter("ERASE", "H", "A1", "");
        Assert.Equal(1, here.Window.Canvas.Pointing.Hovered); // the same circle has another number now
    });

    /// <summary>The table highlights the row that the properties list.</summary>
    [Fact]
    public Task The_row_in_the_table_is_the_row_of_what_was_picked() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Until(() => here.Window.Canvas.IsUpToDate);
        here.Show("Table");
        var (table, list) = (here.Commands.Derivation.Current.Sequence!.Table, here.Find<ListBox>("RowList"));
        for (var row = 0; row < table.Count; row++)
        {
            var entity = table.EntityIndexOf(row);
            here.Window.Canvas.Commands!.PickAt(default, entity, here.Window.Canvas.Scene!.Drawing, remove: false);
            here.Until(() => table.EntityIndexOf(here.Desk.Derived.RowUnderTool) == entity); // a selection is queued like every input
            Assert.Equal(Enumerable.Range(0, table.Count).First(other => table.EntityIndexOf(other) == entity), here.Desk.Derived.RowUnderTool);
            Assert.Equal(here.Desk.Derived.RowUnderTool, list.SelectedIndex);
        }
    });

    private Task With(Action<Operator> test) => fixture.WithOperator(here =>
    {
        var drawing = new DrawingBuilder().Line(0, 0, 100, 0).Arc(50, 50, 20, 0, 90).Circle(150, 50, 20).Square(0, 100, 40).Build();
        here.Commands.Document.Commit("OPEN", new DocumentState { Drawing = drawing });
        here.WaitUntilIdle();
        here.Enter("ZOOM", "W", "-40,-60", "200,160");
        here.Until(() => here.Window.Canvas.Scene is not null && here.Window.Canvas.IsUpToDate);
        test(here);
    });

    private static IReadOnlyList<int> Highlighted(Operator here) => here.Window.Canvas.Selection ?? [];

    private static Drawing Drawn(Operator here) => here.Commands.Document.Current.Drawing!;

    private static Segment Only(Operator here, int entity) => DrawingPick.Segments(Drawn(here), entity).Single();

    private static (Point2D Start, Point2D End) Ends(Operator here, int entity) => (Only(here, entity).Start, Only(here, entity).End);

    private static Point At(Operator here, double x, double y)
    {
        var pixel = here.Window.Canvas.PixelView.ToPixels(new Point2D(x, y));
        return here.Window.Canvas.TranslatePoint(new Point(pixel.X, pixel.Y), here.Window)!.Value;
    }

    private static void Point(Operator here, double x, double y)
    {
        here.Hands.MovePointer(At(here, x, y));
        here.Step();
    }

    private static void Click(Operator here, double x, double y, RawInputModifiers modifiers = RawInputModifiers.None)
    {
        Point(here, x, y);
        here.Hands.Click(At(here, x, y), modifiers: modifiers);
        here.WaitUntilIdle();
    }

    private static void Drag(Operator here, (double X, double Y) from, (double X, double Y) to)
    {
        Point(here, from.X, from.Y);
        here.Hands.PressButton(At(here, from.X, from.Y));
        here.WaitUntilIdle();
        Point(here, (from.X + to.X) / 2.0, (from.Y + to.Y) / 2.0);
        Point(here, to.X, to.Y);
        here.Hands.ReleaseButton(At(here, to.X, to.Y));
        here.WaitUntilIdle();
    }
}
