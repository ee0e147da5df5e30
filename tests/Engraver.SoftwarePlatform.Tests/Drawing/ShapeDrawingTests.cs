using Avalonia;
using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

public class ShapeDrawingTests
{
    [Fact]
    public void A_rectangle_between_pixels_covers_its_borders_partly()
    {
        using var picture = new Picture(20, 20).Draw(c => c.DrawRectangle(Picture.Brush(Colors.White), null, new RoundedRect(new Rect(2.5, 3, 10, 4.25))));

        Assert.Equal(128, picture.Alpha(2, 3));
        Assert.Equal(255, picture.Alpha(3, 3));
        Assert.Equal(64, picture.Alpha(5, 7));
        Assert.Equal(0, picture.Alpha(13, 3));
        Near.Equal(42.5, picture.Area(), 0.1);
    }

    [Fact]
    public void A_border_lies_between_two_rounded_rectangles()
    {
        var box = new RoundedRect(new Rect(10, 10, 60, 40), 10);
        using var picture = new Picture(80, 60).Draw(c => c.DrawRectangle(null, Picture.Pen(Colors.Red, 4), box));

        double Rounded(double width, double height, double radius) => width * height - (4 - Math.PI) * radius * radius;
        Near.Equal(Rounded(64, 44, 12) - Rounded(56, 36, 8), picture.Area(), 1.5);
        Near.Equal(Colors.Red, picture.Color(40, 10));
    }

    [Fact]
    public void A_box_with_one_round_corner_has_three_square_ones()
    {
        var box = new RoundedRect(new Rect(0, 0, 40, 40), new CornerRadius(20, 0, 0, 0).TopLeft, 0, 0, 0);
        using var picture = new Picture(40, 40).Draw(c => c.DrawRectangle(Picture.Brush(Colors.Black), null, box));

        Assert.Equal(0, picture.Alpha(1, 1));
        Assert.Equal(255, picture.Alpha(39, 0));
        Assert.Equal(255, picture.Alpha(0, 39));
        Near.Equal(1600 - (1 - Math.PI / 4) * 400, picture.Area(), 0.6);
    }

    [Fact]
    public void An_ellipse_has_its_fill_and_its_ring()
    {
        using var picture = new Picture(100, 80).Draw(c => c.DrawEllipse(Picture.Brush(Colors.Blue), Picture.Pen(Colors.Yellow, 6), new Rect(10, 10, 80, 60)));

        Near.Equal(Math.PI * 43 * 33, picture.Area(), 6);
        Near.Equal(Colors.Blue, picture.Color(50, 40));
        Near.Equal(Colors.Yellow, picture.Color(10, 40));
    }

    [Fact]
    public void A_scaled_and_turned_line_keeps_its_area()
    {
        using var picture = new Picture(200, 200).Draw(c =>
        {
            c.Transform = Matrix.CreateScale(2, 2) * Matrix.CreateRotation(0.7) * Matrix.CreateTranslation(80, 20);
            c.DrawLine(Picture.Pen(Colors.Black, 3), new Point(10, 0), new Point(50, 0));
        });

        Near.Equal(4 * 40 * 3, picture.Area(), 1.5);
    }

    [Fact]
    public void Half_opaque_over_half_opaque()
    {
        using var picture = new Picture(4, 4, Colors.White).Draw(c =>
        {
            c.DrawRectangle(Picture.Brush(Color.FromArgb(128, 0, 0, 0)), null, new RoundedRect(new Rect(0, 0, 4, 4)));
            c.PushOpacity(0.5, null);
            c.DrawRectangle(Picture.Brush(Colors.Red), null, new RoundedRect(new Rect(0, 0, 2, 4)));
            c.PopOpacity();
        });

        Near.Equal(Color.FromRgb(127, 127, 127), picture.Color(3, 0));
        Near.Equal(Color.FromRgb(191, 63, 63), picture.Color(0, 0));
    }

    [Fact]
    public void Without_soft_edges_a_rectangle_and_a_path_have_whole_pixels_only()
    {
        using var picture = new Picture(60, 40).Draw(c =>
        {
            c.PushRenderOptions(new RenderOptions { EdgeMode = EdgeMode.Aliased });
            c.DrawRectangle(Picture.Brush(Colors.White), null, new RoundedRect(new Rect(2.4, 2.4, 10, 10)));
            c.DrawEllipse(Picture.Brush(Colors.White), null, new Rect(20.3, 5.1, 30, 30));
            c.PopRenderOptions();
        });

        Assert.All(picture.Pixels(), pixel => Assert.True(pixel is 0 or 0xFFFFFFFF));
        Near.Equal(100 + Math.PI * 225, picture.Area(), 12);
    }

    [Fact]
    public void Nothing_is_drawn_for_nothing()
    {
        using var picture = new Picture(10, 10).Draw(c =>
        {
            c.DrawRectangle(Picture.Brush(Colors.Red), Picture.Pen(Colors.Red, 2), new RoundedRect(new Rect(2, 2, 0, 5)));
            c.DrawLine(null, default, new Point(10, 10));
            c.DrawLine(Picture.Pen(Colors.Red, 0), default, new Point(10, 10));
            c.DrawEllipse(Picture.Brush(Colors.Transparent), null, new Rect(0, 0, 10, 10));
            c.DrawRectangle(Picture.Brush(Colors.Red), null, new RoundedRect(new Rect(double.NaN, 0, 5, 5)));
        });

        Assert.Equal(0, picture.Area());
    }
}
