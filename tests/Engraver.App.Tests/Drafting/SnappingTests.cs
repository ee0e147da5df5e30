using Avalonia;
using Avalonia.Input;
using Engraver.App.Canvas;
using Engraver.App.Tests.Canvas;
using Engraver.Core.Geometry;
using Engraver.SoftwarePlatform.Headless;
using Engraver.TestKit;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Views;

namespace Engraver.App.Tests.Drafting;

/// <summary>Snaps and polar tracking at the cursor. The window is 400 by 300 and shows one unit per pixel, the origin in the middle; a line is at y = 50, a
/// circle of radius 40 around 0,-50.</summary>
[Collection(DesktopCollection.Name)]
public sealed class SnappingTests(DesktopFixture fixture)
{
    private static readonly Core.Drawings.Drawing s_drawing = new DrawingBuilder().Line(-100.0, 50.0, 100.0, 50.0).Circle(0.0, -50.0, 40.0).Build();

    [Fact]
    public Task A_typed_snap_finds_the_foot_and_the_tangent_from_the_point_before() => With((_, view, hands, heard) =>
    {
        heard.Aim = new PointRequest(PointPurpose.Place, new Point2D(30.0, 0.0));
        view.Change(state => state with { ObjectSnap = false, OneTimeSnap = 128 });
        hands.Click(new Point(130, 101));
        heard.Aim = new PointRequest(PointPurpose.Place, new Point2D(0.0, 50.0));
        view.Change(state => state with { OneTimeSnap = 256 });
        hands.Click(new Point(238, 188));

        Assert.Equal(new Point2D(30.0, 50.0), heard.Points[0]);
        Assert.True(heard.Points[1].IsNear(new Point2D(40.0 * Math.Sqrt(1.0 - 0.16), -50.0 + 16.0), 1e-9)); // sine of the half angle: 40 / 100
    });

    [Fact]
    public Task Where_a_typed_snap_finds_nothing_a_click_gives_nothing() => With((canvas, view, hands, heard) =>
    {
        heard.Aim = new PointRequest(PointPurpose.Place, new Point2D(30.0, 0.0));
        view.Change(state => state with { OneTimeSnap = 128 });
        hands.Click(new Point(20, 20));
        Assert.Empty(heard.Calls);
        Assert.StartsWith("Specify a place:\nPER\n", canvas.Pointing.Tip, StringComparison.Ordinal);
        view.Change(state => state with { OneTimeSnap = 0 });
        hands.Click(new Point(297, 104));

        Assert.Equal([new Point2D(97.0, 46.0)], heard.Points); // NONE: not even the end of the line
    });

    [Fact]
    public Task Nearest_is_taken_only_where_nothing_else_is() => With((_, view, hands, heard) =>
    {
        heard.Aim = PointRequest.Place;
        view.Change(state => state with { ObjectSnapModes = 1 + 512 });
        hands.Click(new Point(260, 103));
        hands.Click(new Point(295, 103));

        Assert.Equal([new Point2D(60.0, 50.0), new Point2D(100.0, 50.0)], heard.Points);
    });

    /// <summary>A point at 60,20, in green, and one on a frozen layer at 60,-20.</summary>
    [Fact]
    public Task Points_are_shown_and_a_typed_snap_finds_them() => CanvasHost.WithAsync(fixture, WithPoints(), (canvas, view, hands, heard) =>
    {
        canvas.RefineNow();
        fixture.Desktop.Step();
        Assert.Equal(Avalonia.Media.Colors.Lime, hands.PixelAt(262, 132)); // an arm of the cross around 260,130
        Assert.Equal(hands.PixelAt(300, 250), hands.PixelAt(262, 172));
        heard.Aim = PointRequest.Place;
        view.Change(state => state with { ObjectSnap = false, OneTimeSnap = 8 });
        hands.Click(new Point(264, 125));
        Assert.Equal([new Point2D(60.0, 20.0)], heard.Points);
        hands.Click(new Point(262, 172));
        Assert.Single(heard.Points); // invisible objects offer no snap
        view.Change(state => state with { ObjectSnap = true, ObjectSnapModes = 1 + 8, OneTimeSnap = null });
        hands.Click(new Point(264, 125));
        Assert.Equal(new Point2D(60.0, 20.0), heard.Points[1]);
    });

    [Fact]
    public Task Polar_tracking_draws_the_cursor_onto_its_directions_and_says_so() => With((canvas, view, hands, heard) =>
    {
        view.Change(state => state with { ObjectSnap = false, Polar = true, PolarAngle = 45.0 });
        heard.Aim = new PointRequest(PointPurpose.Place, new Point2D(-100.0, -100.0));
        hands.Click(new Point(152, 204));
        Assert.Equal("Specify a place:\nPolar: 69.2965 < 45.00\u00B0", canvas.Pointing.Tip);
        hands.Click(new Point(152, 225));

        Assert.True(heard.Points[0].IsNear(new Point2D(-51.0, -51.0), 1e-9));
        Assert.Equal(new Point2D(-48.0, -75.0), heard.Points[1]);
        Assert.DoesNotContain("Polar", canvas.Pointing.Tip, StringComparison.Ordinal);
    });

    [Fact]
    public Task A_click_with_Shift_says_so() => With((_, _, hands, heard) =>
    {
        heard.Aim = new PointRequest(PointPurpose.Object, null) { ShiftPrefix = "shift:" };
        hands.Click(new Point(260, 100), modifiers: RawInputModifiers.Shift);

        Assert.Equal(["point with shift"], heard.Calls);
    });

    /// <summary>With mouse and keys in the whole window: a click trims, a click with Shift extends, one U undoes both; F10 switches polar
    /// tracking.</summary>
    [Fact]
    public Task Trim_with_the_mouse_and_Shift_and_F10() => fixture.WithOperator(here =>
    {
        here.Desk.Session.Document.Commit("OPEN", new Engraver.Workbench.Documents.DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 100, 0).Line(30, -40, 30, 40).Line(70, -40, 70, 40).Line(40, 20, 60, 20).Build() });
        here.WaitUntilIdle();
        here.Enter("ZOOM", "E", "TRIM");
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();
        here.Hands.Click(At(here, 50, 0));
        here.WaitUntilIdle();
        here.Hands.Click(At(here, 59, 20), modifiers: RawInputModifiers.Shift);
        here.WaitUntilIdle();
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();

        var drawing = here.Desk.Session.Document.Current.Drawing!;
        Assert.Equal(5, drawing.Entities.Count);
        Assert.Equal(70.0, drawing.Parts[drawing.Entities[4].FirstPart].D);
        here.Enter("U");
        Assert.Equal(4, here.Desk.Session.Document.Current.Drawing!.Entities.Count);
        here.Hands.Press(Key.F10);
        here.WaitUntilIdle();
        Assert.True(here.Desk.Session.View.Current.Polar);
        here.Hands.Press(Key.F10);
        here.WaitUntilIdle();
        Assert.False(here.Desk.Session.View.Current.Polar);
    });

    private static Point At(Operator here, double x, double y)
    {
        var pixel = here.Window.Canvas.PixelView.ToPixels(new Point2D(x, y));
        return here.Window.Canvas.TranslatePoint(new Point(pixel.X, pixel.Y), here.Window)!.Value;
    }

    private static Core.Drawings.Drawing WithPoints()
    {
        var drawing = new DrawingBuilder().OnLayer(new Core.Drawings.Layer("COLD", On: true, Frozen: true, Plot: true)).Line(0, 0, 1, 1).Build();
        return drawing with { Points = [new(new Core.Geometry.Vector3D(60.0, 20.0, 5.0), 0, Core.Drawings.DrawingColour.FromCode62(3), Hidden: false), new(new Core.Geometry.Vector3D(60.0, -20.0, 0.0), 1, default, Hidden: false)] };
    }

    private Task With(Action<DrawingCanvas, ViewSession, HeadlessWindow, RecordedCommands> test) => CanvasHost.WithAsync(fixture, s_drawing, test);
}
