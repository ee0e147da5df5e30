using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Tests.Geometry;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

public class ClipTests
{
    private static readonly RoundedRect s_everything = new(new Rect(-10, -10, 500, 500));

    [Fact]
    public void A_rectangle_clips_at_the_nearest_pixel_borders()
    {
        using var picture = new Picture(20, 20).Draw(c =>
        {
            c.PushClip(new Rect(2.4, 2.6, 10, 10));
            c.DrawRectangle(Picture.Brush(Colors.Black), null, s_everything);
            c.PopClip();
        });

        Assert.Equal(100, picture.Area());
        Assert.Equal(255, picture.Alpha(2, 3));
        Assert.Equal(0, picture.Alpha(2, 2));
    }

    [Fact]
    public void A_rounded_clip_and_a_geometry_clip_have_soft_edges()
    {
        using var rounded = new Picture(80, 60).Draw(c =>
        {
            c.PushClip(new RoundedRect(new Rect(10, 10, 60, 40), 12));
            c.DrawRectangle(Picture.Brush(Colors.Black), null, s_everything);
            c.PopClip();
        });
        using var circle = new Picture(80, 60).Draw(c =>
        {
            c.PushGeometryClip(Picture.Platform.CreateEllipseGeometry(new Rect(10, 5, 50, 50)));
            c.DrawRectangle(Picture.Brush(Colors.Black), null, s_everything);
            c.PopGeometryClip();
        });

        Near.Equal(2400 - (4 - Math.PI) * 144, rounded.Area(), 1);
        Near.Equal(Math.PI * 625, circle.Area(), 2.2);
    }

    [Fact]
    public void Clips_within_clips_multiply_and_end_one_by_one()
    {
        using var picture = new Picture(100, 100).Draw(c =>
        {
            c.PushGeometryClip(Picture.Platform.CreateEllipseGeometry(new Rect(0, 0, 100, 100)));
            c.PushClip(new Rect(0, 0, 50, 100));
            c.PushGeometryClip(Picture.Platform.CreateEllipseGeometry(new Rect(-50, 0, 100, 100)));
            c.DrawRectangle(Picture.Brush(Colors.Black), null, s_everything);
            c.PopGeometryClip();
            c.PopClip();
            c.PopGeometryClip();
        });
        var lens = 2 * 2500 * Math.Acos(0.5) - 25 * Math.Sqrt(4 * 2500 - 2500);

        Near.Equal(lens, picture.Area(), 4);
    }

    [Fact]
    public void A_pop_brings_back_the_transform_and_the_clip_of_its_push()
    {
        using var picture = new Picture(30, 30).Draw(c =>
        {
            c.Transform = Matrix.CreateTranslation(5, 5);
            c.PushClip(new Rect(0, 0, 2, 2));
            c.Transform = Matrix.CreateTranslation(20, 20);
            c.PopClip();
            Assert.Equal(Matrix.CreateTranslation(5, 5), c.Transform);
            c.DrawRectangle(Picture.Brush(Colors.Black), null, new RoundedRect(new Rect(0, 0, 10, 10)));
        });

        Assert.Equal(100, picture.Area());
    }

    [Fact]
    public void Clearing_respects_the_clip()
    {
        using var picture = new Picture(20, 20, Colors.White).Draw(c =>
        {
            c.PushClip(new Rect(5, 5, 5, 5));
            c.Clear(Colors.Red);
            c.PopClip();
        });

        Assert.Equal(Colors.Red, picture.Color(7, 7));
        Assert.Equal(Colors.White, picture.Color(4, 7));
        Assert.Equal(25, picture.Pixels().Count(pixel => pixel == 0xFFFF0000));
    }

    [Fact]
    public void Painting_a_scene_region_by_region_gives_the_same_pixels_as_all_at_once()
    {
        using var whole = new Picture(200, 150, Colors.Black).Draw(Scene);
        using var parts = new Picture(200, 150, Colors.Black);
        foreach (var region in new[] { Region((0, 0, 90, 40), (60, 30, 130, 110), (190, 140, 200, 150)), Region((0, 40, 60, 150), (90, 0, 200, 30)), Region((0, 0, 200, 150)) })
        {
            parts.Draw(c =>
            {
                c.PushClip(region);
                c.Clear(Colors.Black);
                Scene(c);
                c.PopClip();
            });
        }

        Assert.Equal(whole.Pixels(), parts.Pixels());
    }

    [Fact]
    public void A_region_of_two_rectangles_leaves_everything_else_alone()
    {
        using var region = Region((2, 2, 6, 6), (10, 10, 16, 12));
        using var picture = new Picture(20, 20).Draw(c =>
        {
            c.PushClip(region);
            Scene(c);
            c.DrawRectangle(Picture.Brush(Colors.Red), null, s_everything);
            c.PopClip();
        });

        Assert.Equal(16 + 12, picture.Area());
        Assert.Equal(Colors.Red, picture.Color(15, 11));
    }

    private static void Scene(IDrawingContextImpl c)
    {
        var gradient = GradientTests.Linear((Colors.Navy, 0), (Colors.Orange, 1));
        c.DrawRectangle(gradient, Picture.Pen(Colors.White, 3), new RoundedRect(new Rect(10.5, 8.5, 120, 90), 14), BoxShadows.Parse("3 4 12 2 #C0FFFF00"));
        c.PushOpacityMask(GradientTests.Linear((Colors.White, 0), (Colors.Transparent, 1)), new Rect(40, 20, 140, 110));
        c.DrawEllipse(Picture.Brush(Color.FromArgb(180, 255, 0, 128)), Picture.Pen(Colors.Lime, 2, PenLineCap.Round, PenLineJoin.Round, 3, 2), new Rect(40, 20, 140, 110));
        c.PopOpacityMask();
        c.PushClip(new RoundedRect(new Rect(100, 60, 80, 70), 20));
        c.DrawRectangle(Picture.Brush(Colors.SteelBlue, 0.7), null, new RoundedRect(new Rect(90, 70, 200, 200)));
        c.PopClip();
        c.DrawLine(Picture.Pen(Colors.White, 1.5), new Point(0, 149.3), new Point(199, 3.7));
    }

    private static IPlatformRenderInterfaceRegion Region(params (int Left, int Top, int Right, int Bottom)[] rectangles)
    {
        var region = Picture.Platform.CreateRegion();
        foreach (var (left, top, right, bottom) in rectangles)
            region.AddRect(RegionTests.Rectangle(left, top, right, bottom));
        return region;
    }
}
