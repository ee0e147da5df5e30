using Avalonia;
using Avalonia.Controls;
using Avalonia.Layout;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Tests.Headless;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

/// <summary>Brushes and pictures that need real controls.</summary>
[Collection(DesktopCollection.Name)]
public sealed class DesktopDrawingTests(DesktopFixture desktop)
{
    [Fact]
    public Task A_visual_brush_shows_a_border_that_is_in_no_window() => desktop.Runner.RunAsync(() =>
    {
        var shown = new Border { Width = 40, Height = 20, Background = Brushes.Red };
        using var picture = Painted(new VisualBrush(shown) { Stretch = Stretch.None });

        Assert.Equal(Colors.Red, picture.Color(50, 30));
        Near.Equal(800, picture.Area(), 1);
        return Task.CompletedTask;
    });

    [Fact]
    public Task A_visual_brush_of_a_control_without_a_template_is_empty() => desktop.Runner.RunAsync(() =>
    {
        // Styles are applied in a tree that has an application's root; without them a button has no look and no size.
        var button = new Button { Content = "Visual brush" };
        using var picture = Painted(new VisualBrush(button) { Stretch = Stretch.None });

        Assert.Equal(0, picture.Area());
        Assert.Equal(default, button.Bounds.Size);
        return Task.CompletedTask;
    });

    [Fact]
    public Task A_visual_brush_shows_a_control_of_a_window() => desktop.Runner.RunAsync(() =>
    {
        var button = new Button { Content = "Shown", Background = Brushes.Blue, Width = 60, Height = 30, HorizontalAlignment = HorizontalAlignment.Left };
        var window = new Window { Width = 200, Height = 100, Content = button };
        window.Show();
        desktop.Desktop.Step();
        using var picture = Painted(new VisualBrush(button) { Stretch = Stretch.None });
        window.Close();
        desktop.Desktop.Step();

        Near.Equal(Colors.Blue, picture.Color(24, 20));
        Assert.Contains(picture.Pixels(), pixel => (pixel & 0xFFFF00) == 0xFFFF00);
        return Task.CompletedTask;
    });

    [Fact]
    public Task A_drawing_brush_is_tiled() => desktop.Runner.RunAsync(() =>
    {
        var drawing = new GeometryDrawing { Brush = Brushes.Lime, Geometry = new RectangleGeometry(new Rect(0, 0, 5, 5)) };
        var group = new DrawingGroup { Children = { drawing, new GeometryDrawing { Brush = Brushes.Black, Geometry = new RectangleGeometry(new Rect(5, 5, 5, 5)) } } };
        var brush = new DrawingBrush(group) { TileMode = TileMode.Tile, DestinationRect = new RelativeRect(0, 0, 10, 10, RelativeUnit.Absolute) };
        using var picture = Painted(brush);

        Assert.Equal(Colors.Lime, picture.Color(2, 2));
        Assert.Equal(Colors.Lime, picture.Color(92, 42));
        Assert.Equal(Colors.Black, picture.Color(58, 27));
        Near.Equal(100 * 60 / 2.0, picture.Area(), 1);
        return Task.CompletedTask;
    });

    private static Picture Painted(IBrush brush) => new Picture(100, 60).Draw(c => c.DrawRectangle(brush, null, new RoundedRect(new Rect(0, 0, 100, 60))));
}
