using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Bitmaps;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

public class BitmapDrawingTests
{
    private static readonly Color s_green = Color.FromRgb(0, 255, 0);

    [Fact]
    public void Pixel_for_pixel_a_bitmap_is_copied()
    {
        using var image = TestImage.FourColors(8);
        using var picture = new Picture(40, 40).Draw(c => c.DrawBitmap(image, 1, new Rect(0, 0, 16, 16), new Rect(10, 12, 16, 16)));

        Assert.Equal(256, picture.Area());
        Assert.Equal(Colors.Red, picture.Color(10, 12));
        Assert.Equal(Colors.White, picture.Color(25, 27));
        Assert.Equal(Colors.Blue, picture.Color(17, 20));
    }

    [Fact]
    public void Part_of_a_bitmap_is_stretched_without_its_neighbours()
    {
        using var image = TestImage.FourColors(8);
        using var picture = new Picture(64, 64).Draw(c => c.DrawBitmap(image, 1, new Rect(8, 0, 8, 8), new Rect(0, 0, 64, 64)));

        Assert.All(picture.Pixels(), pixel => Assert.Equal(0xFF00FF00, pixel));
    }

    [Fact]
    public void Nearest_has_hard_borders_and_bilinear_soft_ones()
    {
        using var image = TestImage.FourColors(1);
        using var hard = new Picture(40, 40).Draw(c =>
        {
            c.PushRenderOptions(new RenderOptions { BitmapInterpolationMode = BitmapInterpolationMode.None });
            c.DrawBitmap(image, 1, new Rect(0, 0, 2, 2), new Rect(0, 0, 40, 40));
            c.PopRenderOptions();
        });
        using var soft = new Picture(40, 40).Draw(c => c.DrawBitmap(image, 1, new Rect(0, 0, 2, 2), new Rect(0, 0, 40, 40)));

        Assert.Equal(Colors.Red, hard.Color(19, 5));
        Assert.Equal(s_green, hard.Color(20, 5));
        Near.Equal(Color.FromRgb(127, 127, 0), soft.Color(20, 5), 8);
    }

    [Fact]
    public void A_bitmap_drawn_small_is_the_mean_of_its_pixels()
    {
        using var stripes = new SoftwareBitmap(new PixelSize(256, 256), new Vector(96, 96));
        for (var y = 0; y < 256; y++)
        {
            for (var x = 0; x < 256; x++)
                stripes.Row(y)[x] = x % 2 == 0 ? 0xFF000000 : 0xFFFFFFFF;
        }
        using var picture = new Picture(32, 32).Draw(c => c.DrawBitmap(stripes, 1, new Rect(0, 0, 256, 256), new Rect(0, 0, 32, 32)));

        Assert.All(picture.Pixels(), pixel => Near.Equal(128, pixel & 255, 2));
    }

    [Fact]
    public void A_bitmap_that_was_written_again_is_not_drawn_from_an_old_copy()
    {
        using var image = (SoftwareBitmap)Picture.Platform.CreateWriteableBitmap(new PixelSize(4, 4), new Vector(96, 96), PixelFormats.Rgba8888, AlphaFormat.Unpremul);
        Write(image, 0x800000FF);
        using var first = new Picture(4, 4).Draw(c => c.DrawBitmap(image, 1, new Rect(0, 0, 4, 4), new Rect(0, 0, 4, 4)));
        Write(image, 0xFF00FF00);
        using var second = new Picture(4, 4).Draw(c => c.DrawBitmap(image, 1, new Rect(0, 0, 4, 4), new Rect(0, 0, 4, 4)));

        Assert.Equal(0x80800000u, first.Pixel(0, 0));
        Assert.Equal(0xFF00FF00u, second.Pixel(0, 0));
    }

    [Fact]
    public void Alpha_of_an_opaque_bitmap_does_not_count()
    {
        using var image = (SoftwareBitmap)Picture.Platform.CreateWriteableBitmap(new PixelSize(4, 4), new Vector(96, 96), PixelFormats.Bgra8888, AlphaFormat.Opaque);
        Write(image, 0x00123456);
        using var picture = new Picture(8, 4).Draw(c =>
        {
            c.DrawBitmap(image, 1, new Rect(0, 0, 4, 4), new Rect(0, 0, 4, 4));
            c.DrawBitmap(image, 1, new Rect(0, 0, 2, 2), new Rect(4, 0, 4, 4));
        });

        Assert.All(picture.Pixels(), pixel => Assert.Equal(0xFF123456, pixel));
    }

    [Fact]
    public void Opacity_and_an_opacity_mask_weaken_a_bitmap()
    {
        using var image = TestImage.FourColors(8);
        using var picture = new Picture(32, 16).Draw(c =>
        {
            c.DrawBitmap(image, 0.5, new Rect(0, 0, 16, 16), new Rect(0, 0, 16, 16));
            c.DrawBitmap(image, Picture.Brush(Color.FromArgb(51, 0, 0, 0)), new Rect(16, 0, 16, 16), new Rect(16, 0, 16, 16));
        });

        Assert.Equal(0x80800000u, picture.Pixel(0, 0));
        Near.Equal(51, picture.Alpha(20, 4), 1);
    }

    [Theory]
    [InlineData(BitmapBlendingMode.SourceOver, 0xFF80607Fu)]
    [InlineData(BitmapBlendingMode.Multiply, 0xFF00307Fu)]
    [InlineData(BitmapBlendingMode.Plus, 0xFF8080FFu)]
    [InlineData(BitmapBlendingMode.Difference, 0xFF8040FFu)]
    [InlineData(BitmapBlendingMode.Source, 0x80804000u)]
    [InlineData(BitmapBlendingMode.DestinationOut, 0x7F00207Fu)]
    [InlineData(BitmapBlendingMode.Xor, 0x7F00207Fu)]
    public void Blending_modes_mix_as_the_compositing_formulas_say(BitmapBlendingMode mode, uint expected)
    {
        // Source: half opaque (255, 128, 0). Destination: opaque (0, 64, 255).
        using var image = new SoftwareBitmap(new PixelSize(8, 2), new Vector(96, 96), PixelFormats.Bgra8888, AlphaFormat.Unpremul);
        Write(image, 0x80FF8000);
        using var picture = new Picture(8, 2, Color.FromRgb(0, 64, 255)).Draw(c =>
        {
            c.PushRenderOptions(new RenderOptions { BitmapBlendingMode = mode });
            c.DrawBitmap(image, 1, new Rect(0, 0, 8, 2), new Rect(0, 0, 8, 2));
            c.PopRenderOptions();
        });

        Near.Equal(Color.FromUInt32(expected), picture.Color(5, 1), 2);
    }

    [Fact]
    public void Resizing_keeps_the_mean_color()
    {
        using var image = TestImage.FourColors(30);
        using var small = (SoftwareBitmap)Picture.Platform.ResizeBitmap(image, new PixelSize(1, 1), BitmapInterpolationMode.HighQuality);
        using var large = (SoftwareBitmap)Picture.Platform.ResizeBitmap(image, new PixelSize(120, 90), BitmapInterpolationMode.HighQuality);

        Near.Equal(Color.FromRgb(127, 127, 127), Color.FromUInt32(small[0, 0]), 1);
        Assert.Equal(new PixelSize(120, 90), large.PixelSize);
        Assert.Equal(0xFF00FF00u, large[119, 0]);
    }

    private static void Write(SoftwareBitmap image, uint pixel)
    {
        using var buffer = image.Lock();
        for (var y = 0; y < image.PixelSize.Height; y++)
            image.Row(y).Fill(pixel);
    }
}
