using Avalonia;
using Avalonia.Input;
using Avalonia.Media;
using Engraver.App.Canvas;
using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Scenes;
using Engraver.Core.Geometry;
using Engraver.SoftwarePlatform.Headless;
using Engraver.TestKit;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Views;

namespace Engraver.App.Tests.Canvas;

/// <summary>The control in a window, with simulated input. The window is 400 by 300 and shows one unit per pixel, the origin in the middle.</summary>
[Collection(DesktopCollection.Name)]
public sealed class DrawingCanvasTests(DesktopFixture fixture)
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(60);
    private static readonly Engraver.Core.Drawings.Drawing s_drawing = new DrawingBuilder().Line(-100.0, 50.0, 100.0, 50.0).Circle(0.0, -50.0, 40.0).Build();

    [Fact]
    public Task The_picture_comes_by_itself_and_is_sharp() => With((canvas, _, hands, _) =>
    {
        fixture.Desktop.StepUntil(() => canvas.IsUpToDate, s_patience);
        Draw();

        Assert.Equal(Colors.White, hands.PixelAt(160, 100));
        Assert.Equal(Color.FromUInt32(CanvasTheme.Dark.Background), hands.PixelAt(160, 103));
        Assert.NotEqual(Color.FromUInt32(CanvasTheme.Dark.Background), hands.PixelAt(160, 200));
    });

    [Fact]
    public Task Where_a_red_line_is_the_picture_is_red_whether_its_layer_or_itself_says_so() => With((canvas, _, hands, _) =>
    {
        var red = new Core.Drawings.Layer("RED", On: true, Frozen: false, Plot: true) { Colour = Core.Drawings.DrawingColour.FromCode62(1) };
        var drawing = new DrawingBuilder().Line(-100.0, -50.0, 100.0, -50.0).OnLayer(red).Line(-100.0, 50.0, 100.0, 50.0).Line(-100.0, 0.0, 100.0, 0.0).Build();
        drawing.Entities[2].Colour = Core.Drawings.DrawingColour.FromCode420(0x2040FF);
        canvas.Scene = CanvasScene.From(drawing);
        canvas.RefineNow();
        Draw();

        Assert.Equal(Colors.Red, hands.PixelAt(160, 100));
        Assert.Equal(Color.FromUInt32(0xFF2040FF), hands.PixelAt(160, 150));
        Assert.Equal(Colors.White, hands.PixelAt(160, 200));
    });

    [Fact]
    public Task A_zoom_shows_the_old_picture_larger_at_once_and_the_new_one_when_the_hand_is_still() => With((canvas, view, hands, _) =>
    {
        canvas.RefineNow();
        var stillness = canvas.RestDelay;
        canvas.RestDelay = TimeSpan.FromHours(1); // independent of the duration of the steps
        hands.Wheel(new Point(200, 100), new Vector(0, 6));
        Draw();
        Assert.Equal(Colors.White, hands.PixelAt(20, 100));
        Assert.Equal(Colors.White, hands.PixelAt(200, 101));

        canvas.RestDelay = stillness;
        fixture.Desktop.StepUntil(() => canvas.IsUpToDate, s_patience);
        Draw();

        Assert.Equal(Colors.White, hands.PixelAt(20, 100));
        Assert.NotEqual(Colors.White, hands.PixelAt(20, 101));
        Assert.True(canvas.PixelView.ToDrawing(new Point2D(200.0, 100.0)).IsNear(new Point2D(0.0, 50.0), 1e-9));
        Assert.True(view.Current.Height < 100.0);
    });

    [Fact]
    public Task The_wheel_pressed_moves_the_drawing_with_the_hand() => With((canvas, view, hands, heard) =>
    {
        hands.Drag(new Point(200, 150), new Point(230, 140), button: MouseButton.Middle);
        hands.DoubleClick(new Point(200, 150), MouseButton.Middle);

        Assert.True(view.Current.Centre.IsNear(new Point2D(-30.0, -10.0), 1e-9));
        Assert.Contains("extents", heard.Calls);
    });

    [Fact]
    public Task Clicks_pick_what_is_under_the_pickbox_and_boxes_select() => With((_, _, hands, heard) =>
    {
        hands.Click(new Point(250, 102));
        hands.Click(new Point(240, 200), modifiers: RawInputModifiers.Shift);
        hands.Drag(new Point(50, 50), new Point(350, 140));
        hands.Drag(new Point(350, 140), new Point(50, 50));

        Assert.Equal(["pick 0", "unpick 1", "window", "crossing"], heard.Calls);
        Assert.True(heard.Points[0].IsNear(new Point2D(-150.0, 100.0), 1e-9) && heard.Points[1].IsNear(new Point2D(150.0, 10.0), 1e-9));
    });

    [Fact]
    public Task A_point_that_is_asked_for_snaps_to_the_end_of_the_line() => With((_, view, hands, heard) =>
    {
        heard.Aim = PointRequest.Place;
        hands.Click(new Point(297, 104));
        view.Change(state => state with { ObjectSnap = false, Snap = true, SnapSpacing = 10.0 });
        hands.Click(new Point(298, 103));

        Assert.Equal([new Point2D(100.0, 50.0), new Point2D(100.0, 50.0)], heard.Points);
        Assert.Equal(["point", "point"], heard.Calls);
    });

    [Fact]
    public Task The_crosshair_follows_and_a_selection_lights_up() => With((canvas, _, hands, _) =>
    {
        hands.MovePointer(new Point(60, 60));
        canvas.Selection = [0];
        canvas.RefineNow();
        Draw();

        Assert.Equal(Colors.White, hands.PixelAt(60 - 8, 60));
        Assert.Equal(Color.FromUInt32(CanvasTheme.Dark.Selected), hands.PixelAt(150, 100));
        Assert.Equal(Color.FromUInt32(0xFF007FFF), hands.PixelAt(100, 100));
    });

    [Fact]
    public Task Esc_ends_a_box_before_it_reaches_the_command() => With((canvas, _, hands, heard) =>
    {
        hands.Click(new Point(50, 50));
        canvas.Pointing.Escape();
        canvas.Pointing.Escape();

        Assert.Equal(["cancel"], heard.Calls);
    });

    [Fact]
    public Task The_light_theme_is_white_with_black_lines_and_switched_off_layers_are_gone() => With((canvas, view, hands, _) =>
    {
        view.Change(state => state with { Theme = DesktopTheme.Light });
        canvas.RefineNow();
        Draw();
        Assert.Equal(Colors.Black, hands.PixelAt(200, 100));
        Assert.Equal(Colors.White, hands.PixelAt(203, 103));

        view.Change(state => state with { Shown = CanvasLayers.None });
        canvas.RefineNow();
        Draw();
        Assert.Equal(Colors.White, hands.PixelAt(200, 100));
    });

    [Fact]
    public Task On_a_dense_screen_the_picture_has_its_pixels() => With((canvas, _, hands, _) =>
    {
        hands.SetScale(2.0);
        canvas.RefineNow();
        Draw();

        Assert.Equal(new PixelSize(800, 600), canvas.PixelView.Size);
        Assert.Equal(Colors.White, hands.PixelAt(400, 200));
        Assert.NotEqual(Colors.White, hands.PixelAt(400, 204));
        hands.SetScale(1.0);
    });

    /// <summary>An object snap overrides ORTHO, which needs a previous point.</summary>
    [Fact]
    public Task With_ortho_a_point_goes_straight_across_or_up_from_the_one_before() => With((_, view, hands, heard) =>
    {
        view.Change(state => state with { Ortho = true });
        heard.Aim = new PointRequest(PointPurpose.Place, new Point2D(-120.0, -20.0));
        hands.Click(new Point(330, 180));
        hands.Click(new Point(90, 20));
        hands.Click(new Point(297, 104));
        heard.Aim = PointRequest.Place;
        hands.Click(new Point(330, 180));

        Assert.Equal([new Point2D(130.0, -20.0), new Point2D(-120.0, 130.0), new Point2D(100.0, 50.0), new Point2D(130.0, -30.0)], heard.Points);
    });

    [Fact]
    public Task A_line_leads_from_the_point_before_to_where_a_click_would_be() => With((canvas, view, hands, heard) =>
    {
        view.Change(state => state with { Ortho = true, DynamicInput = false });
        hands.MovePointer(new Point(330, 280));
        heard.Aim = new PointRequest(PointPurpose.Place, new Point2D(-120.0, -100.0));
        canvas.Pointing.UpdatePointRequest();
        Draw();

        Assert.Contains(Enumerable.Range(100, 60), x => hands.PixelAt(x, 249) != Color.FromUInt32(CanvasTheme.Dark.Background) || hands.PixelAt(x, 250) != Color.FromUInt32(CanvasTheme.Dark.Background));
        Assert.Null(canvas.Pointing.Box);
    });

    [Fact]
    public Task The_opposite_corner_is_asked_for_with_a_box_and_nothing_snaps() => With((canvas, _, hands, heard) =>
    {
        heard.Aim = new PointRequest(PointPurpose.Corner, new Point2D(0.0, 0.0));
        hands.MovePointer(new Point(297, 104));
        Assert.Equal((new Point2D(200.0, 150.0), new Point2D(297.0, 104.0), false), (canvas.Pointing.Box!.Value.From, canvas.Pointing.Box.Value.To, canvas.Pointing.Box.Value.IsCrossing));
        hands.MovePointer(new Point(103, 104));
        Assert.True(canvas.Pointing.Box!.Value.IsCrossing);
        hands.Click(new Point(297, 104));

        Assert.Equal([new Point2D(97.0, 46.0)], heard.Points);
    });

    [Fact]
    public Task Where_an_object_is_asked_for_nothing_snaps() => With((canvas, _, hands, heard) =>
    {
        heard.Aim = new PointRequest(PointPurpose.Object, null);
        hands.Click(new Point(297, 102));

        Assert.Equal([new Point2D(97.0, 48.0)], heard.Points);
        Assert.Equal("Specify a place:", canvas.Pointing.Tip);
    });

    [Fact]
    public Task Box_line_and_tip_go_along_when_the_view_changes_under_a_still_hand() => With((canvas, view, hands, heard) =>
    {
        heard.Aim = new PointRequest(PointPurpose.Corner, new Point2D(0.0, 0.0));
        hands.MovePointer(new Point(297, 104));
        view.SetCentre(new Point2D(50.0, 0.0), view.Current.Height);
        Assert.Equal((new Point2D(150.0, 150.0), new Point2D(297.0, 104.0)), (canvas.Pointing.Box!.Value.From, canvas.Pointing.Box.Value.To));
        Assert.Equal("Specify a place:\n147.0000 x 46.0000", canvas.Pointing.Tip);
        view.Change(state => state with { DynamicInput = false });
        Assert.Equal("", canvas.Pointing.Tip);
        hands.LeavePointer();
        Assert.Null(canvas.Pointing.Box);
    });

    [Fact]
    public Task A_box_that_was_begun_keeps_its_corner_in_the_drawing_when_the_view_changes() => With((canvas, view, hands, heard) =>
    {
        hands.Click(new Point(250, 130));
        hands.MovePointer(new Point(297, 104));
        Assert.Equal(new Point2D(250.0, 130.0), canvas.Pointing.Box!.Value.From);
        view.SetCentre(new Point2D(50.0, 0.0), view.Current.Height);
        Assert.Equal((new Point2D(200.0, 130.0), new Point2D(297.0, 104.0)), (canvas.Pointing.Box!.Value.From, canvas.Pointing.Box.Value.To));
        heard.Aim = new PointRequest(PointPurpose.Place, null);
        hands.MovePointer(new Point(298, 104));
        Assert.Null(canvas.Pointing.Box);
    });

    [Fact]
    public Task What_is_asked_and_where_stands_beside_the_crosshair() => With((canvas, view, hands, heard) =>
    {
        hands.MovePointer(new Point(230, 110));
        Assert.Equal("", canvas.Pointing.Tip);
        heard.Aim = PointRequest.Place;
        canvas.Pointing.UpdatePointRequest();
        Assert.Equal("Specify a place:\n30.0000, 40.0000", canvas.Pointing.Tip);
        Draw();
        Assert.NotEqual(Color.FromUInt32(CanvasTheme.Dark.Background), hands.PixelAt(230 + 18, 110 + 30));
        heard.Aim = new PointRequest(PointPurpose.Place, new Point2D(0.0, 40.0));
        hands.MovePointer(new Point(200, 130));
        Assert.Equal("Specify a place:\n20.0000 < 270.00\u00B0", canvas.Pointing.Tip);
        heard.Aim = new PointRequest(PointPurpose.Corner, new Point2D(10.0, 40.0));
        hands.MovePointer(new Point(200, 131));
        Assert.Equal("Specify a place:\n10.0000 x 21.0000", canvas.Pointing.Tip);
        view.Change(state => state with { DynamicInput = false });
        hands.MovePointer(new Point(230, 111));
        Assert.Equal("", canvas.Pointing.Tip);
    });

    /// <summary>The preview of a click is computed on another thread and drawn; it disappears with the prompt.</summary>
    [Fact]
    public Task What_a_click_would_give_is_seen_while_the_cursor_moves() => With((canvas, _, hands, heard) =>
    {
        heard.Aim = PointRequest.Place with { Ghost = place => [Segment.FromLine(new Point2D(-100.0, place.Y), new Point2D(100.0, place.Y))] };
        hands.MovePointer(new Point(230, 130));
        fixture.Desktop.StepUntil(() => canvas.Pointing.Ghost is [{ Start.Y: 20.0 }], s_patience);
        hands.MovePointer(new Point(230, 120));
        fixture.Desktop.StepUntil(() => canvas.Pointing.Ghost is [{ Start.Y: 30.0 }], s_patience);
        Draw();
        Assert.Contains(Enumerable.Range(110, 20), x => hands.PixelAt(x, 120) != Color.FromUInt32(CanvasTheme.Dark.Background));
        heard.Aim = PointRequest.Place;
        hands.MovePointer(new Point(231, 120));

        Assert.Empty(canvas.Pointing.Ghost);
    });

    /// <summary>The preview of Enter is drawn wherever the cursor is, and disappears with the prompt.</summary>
    [Fact]
    public Task What_Enter_would_give_is_seen_without_the_cursor() => With((canvas, _, hands, heard) =>
    {
        heard.Aim = null;
        heard.Preview = _ => [Segment.FromLine(new Point2D(-100.0, 30.0), new Point2D(100.0, 30.0))];
        canvas.Pointing.UpdatePointRequest();
        fixture.Desktop.StepUntil(() => canvas.Pointing.Ghost is [{ Start.Y: 30.0 }], s_patience);
        Draw();
        Assert.Contains(Enumerable.Range(110, 20), x => hands.PixelAt(x, 120) != Color.FromUInt32(CanvasTheme.Dark.Background));
        heard.Preview = _ => [Segment.FromLine(new Point2D(-100.0, 20.0), new Point2D(100.0, 20.0))];
        canvas.Pointing.UpdatePointRequest();
        fixture.Desktop.StepUntil(() => canvas.Pointing.Ghost is [{ Start.Y: 20.0 }], s_patience);
        heard.Preview = null;
        canvas.Pointing.UpdatePointRequest();

        Assert.Empty(canvas.Pointing.Ghost);
    });

    private void Draw() => fixture.Desktop.Step();

    private Task With(Action<DrawingCanvas, ViewSession, HeadlessWindow, RecordedCommands> test) => CanvasHost.WithAsync(fixture, s_drawing, test);
}
