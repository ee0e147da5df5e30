using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Tests.Text;
using Engraver.SoftwarePlatform.Text;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

public class GlyphDrawingTests
{
    [Fact]
    public void A_letter_stands_on_its_baseline()
    {
        using var picture = Text("H", 40, Colors.Black, Colors.White, 80, 60, x: 10, y: 50);

        Assert.True(Darkest(picture, 49) < 10);
        Assert.True(Darkest(picture, 50) > 245);
        // The height of capitals in Inter is 0.727 em.
        Assert.True(Darkest(picture, 50 - 29) < 60);
        Assert.True(Darkest(picture, 50 - 31) > 245);
    }

    [Fact]
    public void Masks_and_outlines_cover_the_same_area()
    {
        double Area(double size, double scale)
        {
            using var picture = new Picture(700, 300).Draw(c =>
            {
                c.Transform = Matrix.CreateScale(scale, scale);
                c.DrawGlyphRun(Picture.Brush(Color.FromRgb(128, 128, 128)), Inter.Run("Rag", size, 4, 200 / scale));
            });
            return picture.Area();
        }

        // 96 pixels are drawn from masks, 100 as an outline.
        Near.Equal(Area(100, 1) * 0.96 * 0.96, Area(48, 2), Area(48, 2) * 0.03);
    }

    [Fact]
    public void Text_moves_in_quarters_of_a_pixel()
    {
        using var first = Text("l", 14, Colors.Black, Colors.White, 30, 20, x: 4, y: 15);
        using var same = Text("l", 14, Colors.Black, Colors.White, 30, 20, x: 4.1, y: 15.3);
        using var other = Text("l", 14, Colors.Black, Colors.White, 30, 20, x: 4.25, y: 15);

        Assert.Equal(first.Pixels(), same.Pixels());
        Assert.NotEqual(first.Pixels(), other.Pixels());
    }

    [Fact]
    public void Dark_and_light_text_are_strengthened_differently()
    {
        using var dark = Text("mn", 12, Colors.Black, Colors.White, 40, 20, 4, 15);
        using var light = Text("mn", 12, Colors.White, Colors.Black, 40, 20, 4, 15);
        double darkInk = dark.Pixels().Sum(pixel => 255.0 - (pixel & 255)), lightInk = light.Pixels().Sum(pixel => (double)(pixel & 255));

        Assert.NotEqual(darkInk, lightInk);
        Near.Equal(1.0, darkInk / lightInk, 0.35);
        Assert.Equal(Colors.White, dark.Color(0, 0));
    }

    [Fact]
    public void Contrast_leaves_none_and_full_as_they_are_and_never_turns_back()
    {
        foreach (var color in new[] { 0xFF000000u, 0xFF555555u, 0xFFAAAAAAu, 0xFFFFFFFFu })
        {
            byte[] levels = [.. Enumerable.Range(0, 256).Select(i => (byte)i)];
            TextTone.From(color).Apply(levels);

            Assert.Equal(0, levels[0]);
            Assert.Equal(255, levels[255]);
            Assert.Equal(levels.Order(), levels);
        }
    }

    [Fact]
    public void Text_cut_by_a_clip_or_by_the_edge_is_the_same_text()
    {
        using var whole = Text("Wide", 14, Colors.Black, Colors.White, 60, 24, 4, 17);
        using var clipped = new Picture(60, 24, Colors.White).Draw(context =>
        {
            context.PushClip(new Rect(9, 8, 17, 7));
            context.DrawGlyphRun(Picture.Brush(Colors.Black), Inter.Run("Wide", 14, 4, 17));
            context.PopClip();
        });
        foreach (var width in Enumerable.Range(8, 32))
        {
            using var narrow = Text("Wide", 14, Colors.Black, Colors.White, width, 24, 4, 17);
            for (var y = 0; y < 24; y++)
            {
                for (var x = 0; x < width; x++)
                    Assert.Equal(whole.Pixel(x, y), narrow.Pixel(x, y));
            }
        }

        for (var y = 0; y < 24; y++)
        {
            for (var x = 0; x < 60; x++)
                Assert.Equal(x is >= 9 and < 26 && y is >= 8 and < 15 ? whole.Pixel(x, y) : 0xFFFFFFFF, clipped.Pixel(x, y));
        }
    }

    [Fact]
    public void A_gradient_can_be_the_foreground()
    {
        using var picture = new Picture(200, 40).Draw(c => c.DrawGlyphRun(GradientTests.Linear((Colors.Red, 0), (Colors.Blue, 1)), Inter.Run("MMMMMM", 30, 5, 32)));
        var inked = Enumerable.Range(0, 200).Where(x => picture.Alpha(x, 20) > 250).Select(x => picture.Color(x, 20)).ToList();

        Assert.True(inked[0].R > 180 && inked[0].B < 80);
        Assert.True(inked[^1].B > 150 && inked[^1].R < 110);
    }

    [Fact]
    public void Turned_text_is_the_same_text()
    {
        using var picture = new Picture(100, 100).Draw(c =>
        {
            c.Transform = Matrix.CreateRotation(Math.PI / 2) * Matrix.CreateTranslation(50, 10);
            c.DrawGlyphRun(Picture.Brush(Colors.Black), Inter.Run("I", 40, 0, 0));
        });
        using var upright = new Picture(100, 100).Draw(c => c.DrawGlyphRun(Picture.Brush(Colors.Black), Inter.Run("I", 100, 10, 90)));

        Near.Equal(upright.Area() * 0.16, picture.Area(), upright.Area() * 0.01);
        Assert.True(picture.Alpha(65, 16) > 0 || picture.Alpha(65, 15) > 0);
    }

    [Fact]
    public void Drawing_the_same_text_again_allocates_nothing_per_glyph()
    {
        using var picture = new Picture(600, 40);
        using var context = picture.Bitmap.CreateDrawingContext();
        var brush = Picture.Brush(Colors.Black);
        var shortRun = Inter.Run("nn", 14, 4, 30);
        var longRun = Inter.Run("nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn", 14, 4, 30);
        long Allocated(Avalonia.Platform.IGlyphRunImpl run)
        {
            context.DrawGlyphRun(brush, run);
            var before = GC.GetAllocatedBytesForCurrentThread();
            context.DrawGlyphRun(brush, run);
            return GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Allocated(longRun);
        Assert.Equal(Allocated(shortRun), Allocated(longRun));
    }

    private static int Darkest(Picture picture, int y) => Enumerable.Range(0, picture.Bitmap.PixelSize.Width).Min(x => (int)picture.Color(x, y).G);

    private static Picture Text(string text, double size, Color color, Color background, int width, int height, double x, double y) =>
        new Picture(width, height, background).Draw(c => c.DrawGlyphRun(Picture.Brush(color), Inter.Run(text, size, x, y)));
}
