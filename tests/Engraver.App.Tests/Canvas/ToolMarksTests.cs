using Avalonia.Media;
using Engraver.App.Canvas;
using Engraver.App.Canvas.Colours;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Settings;

namespace Engraver.App.Tests.Canvas;

/// <summary>The drawn marks of machine and playback. The position is 50 pixels right of the middle and 30 above it.</summary>
[Collection(DesktopCollection.Name)]
public sealed class ToolMarksTests(DesktopFixture fixture)
{
    private const int X = 250;
    private const int Y = 120;

    private static readonly Engraver.Core.Drawings.Drawing s_drawing = new DrawingBuilder().Line(-190.0, -140.0, -180.0, -140.0).Build();

    [Theory]
    [InlineData(DesktopTheme.Dark)]
    [InlineData(DesktopTheme.Light)]
    [InlineData(DesktopTheme.HighContrast)]
    public Task The_machine_is_solid_and_the_playback_hollow_in_another_colour(DesktopTheme theme) => CanvasHost.WithAsync(fixture, s_drawing, (canvas, view, hands, _) =>
    {
        view.Change(state => state with { Theme = theme });
        var colours = CanvasTheme.Of(theme);
        canvas.Machine = Mark("");
        canvas.RefineNow();
        fixture.Desktop.Step();
        Assert.Equal(Color.FromUInt32(colours.Tool), hands.PixelAt(X, Y));
        Assert.Equal(Color.FromUInt32(colours.Tool), hands.PixelAt(X + 3, Y - 3));

        (canvas.Machine, canvas.PlaybackPosition) = (null, new Point2D(50, 30));
        fixture.Desktop.Step();
        Assert.Equal(Color.FromUInt32(colours.Background), hands.PixelAt(X, Y));
        Assert.Equal(Color.FromUInt32(colours.Playback), hands.PixelAt(X + 14, Y));
        Assert.NotEqual(colours.Tool, colours.Playback);

        canvas.Machine = Mark("");
        fixture.Desktop.Step();
        Assert.Equal(Color.FromUInt32(colours.Tool), hands.PixelAt(X, Y)); // both are visible at the same position
        Assert.Equal(Color.FromUInt32(colours.Playback), hands.PixelAt(X + 17, Y));
    });

    [Fact]
    public Task The_trail_is_brighter_towards_the_machine() => CanvasHost.WithAsync(fixture, s_drawing, (canvas, _, hands, _) =>
    {
        canvas.RefineNow();
        canvas.Machine = new MachineMark(new Point2D(50, 30), [.. Enumerable.Range(0, 101).Select(step => new Point2D(-50 + step, 30))], default, DrawingScale.Millimetres, "");
        fixture.Desktop.Step();

        Assert.True(hands.PixelAt(X - 90, Y).R > hands.PixelAt(X - 90, Y + 8).R);
        Assert.True(hands.PixelAt(X - 25, Y).R > hands.PixelAt(X - 90, Y).R);
    });

    [Fact]
    public Task A_place_that_is_not_certain_is_grey_and_a_note_says_why() => CanvasHost.WithAsync(fixture, s_drawing, (canvas, _, hands, _) =>
    {
        canvas.RefineNow();
        canvas.Machine = Mark("why");
        fixture.Desktop.Step();

        Assert.Equal(Color.FromUInt32(CanvasTheme.Dark.Rapid), hands.PixelAt(X, Y));
        Assert.True(canvas.Children.OfType<MachineNote>().Single().IsVisible);
        canvas.Machine = Mark("");
        fixture.Desktop.Step();
        Assert.False(canvas.Children.OfType<MachineNote>().Single().IsVisible);
    });

    [Fact]
    public Task Outside_the_canvas_an_arrow_at_its_edge_points_to_the_machine() => CanvasHost.WithAsync(fixture, s_drawing, (canvas, _, hands, _) =>
    {
        canvas.RefineNow();
        canvas.Machine = new MachineMark(new Point2D(1000, 0), [], default, DrawingScale.Millimetres, "");
        fixture.Desktop.Step();

        Assert.Equal(Color.FromUInt32(CanvasTheme.Dark.Tool), hands.PixelAt(385, 150));
    });

    private static MachineMark Mark(string note) => new(new Point2D(60, 50), [], new Vector2D(10, 20), DrawingScale.Millimetres, note);
}
