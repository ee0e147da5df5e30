using Engraver.App.Canvas.Interaction;
using Engraver.Core.Geometry;

namespace Engraver.App.Tests.Canvas.Interaction;

public class PointerStateMachineTests
{
    private static readonly Point2D s_here = new(100.0, 100.0);
    private static readonly Point2D s_right = new(300.0, 250.0);
    private static readonly Point2D s_left = new(20.0, 250.0);
    private readonly PointerStateMachine _machine = new();

    [Fact]
    public void A_click_on_something_picks_it_and_shift_takes_it_out()
    {
        Assert.Equal(new CanvasIntent.Pick(s_here, Remove: false), Press(s_here, hits: true));
        Assert.Equal(CanvasIntent.None, _machine.Release(s_here, PointerButton.Left));
        Assert.Equal(new CanvasIntent.Pick(s_here, Remove: true), _machine.Press(s_here, PointerButton.Left, shift: true, 1, () => true));
    }

    [Fact]
    public void Two_clicks_on_nothing_make_a_window_to_the_right_and_a_crossing_to_the_left()
    {
        var window = BoxTo(s_right);
        var crossing = BoxTo(s_left);

        Assert.Equal((new SelectionBox(s_here, s_right), false), (window.Box, window.Box.IsCrossing));
        Assert.Equal((new SelectionBox(s_here, s_left), true), (crossing.Box, crossing.Box.IsCrossing));
        Assert.Null(_machine.Box);
    }

    [Fact]
    public void A_drag_on_nothing_is_a_box_that_letting_go_ends()
    {
        Press(s_here, hits: false);
        _machine.Move(s_right);

        Assert.Equal(new SelectionBox(s_here, s_right), _machine.Box);
        Assert.Equal(new CanvasIntent.Select(new SelectionBox(s_here, s_right), false), _machine.Release(s_right, PointerButton.Left));
    }

    [Fact]
    public void A_trembling_hand_is_no_drag()
    {
        Press(s_here, hits: false);

        Assert.Equal(CanvasIntent.None, _machine.Release(s_here + new Vector2D(2.0, 1.0), PointerButton.Left));
        Assert.NotNull(_machine.Box);
    }

    [Fact]
    public void A_box_that_was_begun_is_given_up_when_a_command_asks_for_a_point_or_something_else_is_shown()
    {
        Press(s_here, hits: false);
        _machine.AsksForPoint = false;
        Assert.NotNull(_machine.Box);
        _machine.AsksForPoint = true;
        Assert.Null(_machine.Box);

        _machine.AsksForPoint = false;
        Press(s_here, hits: false);
        _machine.DropBox();
        Assert.Null(_machine.Box);
        Assert.Equal(new CanvasIntent.Pick(s_right, Remove: false), Press(s_right, hits: true));
    }

    [Fact]
    public void The_first_corner_of_a_box_stays_in_the_drawing_when_the_view_is_zoomed()
    {
        _machine.ViewMoved(at => at); // without a box this has no effect
        Press(s_here, hits: false);
        _machine.Release(s_here, PointerButton.Left);
        _machine.ViewMoved(at => new Point2D(at.X * 2.0, at.Y + 5.0));

        Assert.Equal(new CanvasIntent.Select(new SelectionBox(new Point2D(200.0, 105.0), s_right), false), Press(s_right, hits: false));
    }

    [Fact]
    public void The_second_corner_ends_the_box_even_over_an_entity()
    {
        Press(s_here, hits: false);
        _machine.Release(s_here, PointerButton.Left);

        Assert.IsType<CanvasIntent.Select>(Press(s_right, hits: true));
    }

    [Fact]
    public void The_wheel_pressed_pans_and_pressed_twice_shows_everything()
    {
        Assert.Equal(CanvasIntent.None, _machine.Press(s_here, PointerButton.Middle, false, 1, Never));
        Assert.Equal(new CanvasIntent.Pan(new Vector2D(10.0, -5.0)), _machine.Move(s_here + new Vector2D(10.0, -5.0)));
        Assert.Equal(new CanvasIntent.Pan(new Vector2D(1.0, 0.0)), _machine.Move(s_here + new Vector2D(11.0, -5.0)));
        _machine.Release(s_here, PointerButton.Middle);

        Assert.IsType<CanvasIntent.Hover>(_machine.Move(s_right));
        Assert.Equal(new CanvasIntent.ZoomExtents(), _machine.Press(s_here, PointerButton.Middle, false, 2, Never));
    }

    [Fact]
    public void Forward_is_nearer_about_the_cursor_and_back_again_is_the_same()
    {
        var nearer = Assert.IsType<CanvasIntent.Zoom>(_machine.Wheel(s_here, 2.0));
        var farther = Assert.IsType<CanvasIntent.Zoom>(_machine.Wheel(s_here, -2.0));

        Assert.Equal(s_here, nearer.About);
        Assert.True(nearer.Factor > 1.0);
        Assert.Equal(1.0, nearer.Factor * farther.Factor, 12);
    }

    [Fact]
    public void A_click_is_a_point_while_a_command_asks_for_one()
    {
        _machine.AsksForPoint = true;

        Assert.Equal(new CanvasIntent.SubmitPoint(s_here), Press(s_here, hits: true));
        Assert.Null(_machine.Box);
    }

    [Fact]
    public void A_double_click_opens_and_leaves_no_box()
    {
        Press(s_here, hits: false);
        _machine.Release(s_here, PointerButton.Left);

        Assert.Equal(new CanvasIntent.Open(s_here), _machine.Press(s_here, PointerButton.Left, false, 2, Never));
        Assert.Null(_machine.Box);
    }

    [Fact]
    public void Esc_ends_the_box_first_and_then_the_command()
    {
        Press(s_here, hits: false);

        Assert.Equal(CanvasIntent.None, _machine.Escape());
        Assert.Null(_machine.Box);
        Assert.Equal(new CanvasIntent.Cancel(), _machine.Escape());
    }

    [Fact]
    public void Nothing_stays_pressed_when_the_mouse_is_taken_away()
    {
        _machine.Press(s_here, PointerButton.Middle, false, 1, Never);
        _machine.OnCaptureLost();

        Assert.False(_machine.IsPanning);
        Assert.IsType<CanvasIntent.Hover>(_machine.Move(s_right));
    }

    private static bool Never() => throw new InvalidOperationException("Nobody asked what is under the cursor.");

    private CanvasIntent Press(Point2D at, bool hits) => _machine.Press(at, PointerButton.Left, shift: false, 1, () => hits);

    private CanvasIntent.Select BoxTo(Point2D corner)
    {
        Press(s_here, hits: false);
        _machine.Release(s_here, PointerButton.Left);
        _machine.Move(corner);
        return Assert.IsType<CanvasIntent.Select>(Press(corner, hits: false));
    }
}
