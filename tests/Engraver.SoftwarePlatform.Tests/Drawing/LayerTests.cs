using Avalonia;
using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

public class LayerTests
{
    [Fact]
    public void An_opacity_mask_lets_through_what_its_alpha_says()
    {
        using var picture = new Picture(100, 20, Colors.Black).Draw(c =>
        {
            c.PushOpacityMask(GradientTests.Linear((Colors.White, 0), (Colors.Transparent, 1)), new Rect(0, 0, 100, 20));
            c.DrawRectangle(Picture.Brush(Colors.White), null, new RoundedRect(new Rect(0, 0, 100, 20)));
            c.PopOpacityMask();
        });

        Near.Equal(Color.FromRgb(204, 204, 204), picture.Color(20, 10), 3);
        Near.Equal(Color.FromRgb(51, 51, 51), picture.Color(80, 10), 3);
    }

    [Fact]
    public void Outside_of_a_masks_area_nothing_is_seen()
    {
        using var picture = new Picture(40, 40).Draw(c =>
        {
            c.PushOpacityMask(Picture.Brush(Colors.White), new Rect(10, 10, 10, 10));
            c.DrawRectangle(Picture.Brush(Colors.Red), null, new RoundedRect(new Rect(0, 0, 40, 40)));
            c.PopOpacityMask();
        });

        Assert.Equal(100, picture.Area());
        Assert.Equal(Colors.Red, picture.Color(12, 12));
    }

    [Fact]
    public void A_group_with_full_handling_is_transparent_as_a_whole()
    {
        using var picture = new Picture(40, 40, Colors.White).Draw(c =>
        {
            c.PushRenderOptions(new RenderOptions { RequiresFullOpacityHandling = true });
            c.PushOpacity(0.5, new Rect(0, 0, 40, 40));
            c.DrawRectangle(Picture.Brush(Colors.Black), null, new RoundedRect(new Rect(0, 0, 30, 40)));
            c.DrawRectangle(Picture.Brush(Colors.Red), null, new RoundedRect(new Rect(10, 0, 30, 40)));
            c.PopOpacity();
            c.PopRenderOptions();
        });

        Near.Equal(Color.FromRgb(255, 127, 127), picture.Color(20, 20));
        Near.Equal(Color.FromRgb(127, 127, 127), picture.Color(5, 20));
    }

    [Fact]
    public void A_mask_works_inside_of_a_clip_and_after_a_transform()
    {
        using var picture = new Picture(100, 60).Draw(c =>
        {
            c.Transform = Matrix.CreateScale(2, 2) * Matrix.CreateTranslation(10, 10);
            c.PushClip(new RoundedRect(new Rect(0, 0, 30, 20), 10));
            c.PushOpacityMask(Picture.Brush(Color.FromArgb(128, 0, 0, 0)), new Rect(0, 0, 40, 40));
            c.DrawRectangle(Picture.Brush(Colors.Red), null, new RoundedRect(new Rect(0, 0, 40, 40)));
            c.PopOpacityMask();
            c.PopClip();
        });

        Near.Equal(128, picture.Alpha(40, 30), 1);
        Near.Equal((60 * 40 - (4 - Math.PI) * 400) * 128 / 255, picture.Area(), 3);
    }

    [Fact]
    public void A_layer_of_the_context_is_copied_as_it_is()
    {
        using var picture = new Picture(20, 20, Colors.White).Draw(c =>
        {
            using var layer = c.CreateLayer(new PixelSize(20, 20));
            using (var inner = layer.CreateDrawingContext())
                inner.DrawRectangle(Picture.Brush(Colors.Red), null, new RoundedRect(new Rect(5, 5, 5, 5)));
            layer.Blit(c);
        });

        Assert.Equal(25, picture.Area());
        Assert.Equal(Colors.Red, picture.Color(7, 7));
    }
}
