using Avalonia;
using Engraver.SoftwarePlatform.Bitmaps;

namespace Engraver.SoftwarePlatform.Tests.Bitmaps;

public class ScalingTests
{
    [Theory]
    [InlineData(10, 10)]
    [InlineData(10, 3)]
    [InlineData(7, 5)]
    [InlineData(1000, 7)]
    [InlineData(3, 1)]
    public void Every_source_pixel_counts_once_in_all_and_each_mean_is_a_whole_one(int source, int target)
    {
        var weights = AreaWeights.Along(source, target);
        var counted = new double[source];
        foreach (var mean in weights)
        {
            var sum = 0.0;
            for (var i = mean.First; i <= mean.Last; i++)
            {
                sum += mean[i];
                counted[i] += mean[i];
            }

            Assert.Equal(1.0, sum, 5);
        }

        Assert.All(counted, part => Assert.Equal((double)target / source, part, 4));
    }

    [Fact]
    public void Enlarged_without_smoothing_each_pixel_becomes_a_block()
    {
        using var source = Bitmap(2, 2, 0xFFFF0000, 0xFF00FF00, 0xFF0000FF, 0xFFFFFFFF);
        using var large = BitmapScaling.Resized(source, new PixelSize(6, 4), isSmooth: false);

        for (var y = 0; y < 4; y++)
        {
            for (var x = 0; x < 6; x++) Assert.Equal(source[x / 3, y / 2], large[x, y]);
        }
    }

    [Fact]
    public void Enlarged_with_smoothing_the_pixels_between_two_colours_lie_between_them()
    {
        using var source = Bitmap(2, 1, 0xFF000000, 0xFFFFFFFF);
        using var large = BitmapScaling.Resized(source, new PixelSize(40, 3), isSmooth: true);

        var grays = large.Row(1).ToArray().Select(pixel => (int)(pixel & 0xFF)).ToArray();
        Assert.Equal(grays.Order(), grays);
        Assert.Equal((0, 255), (grays[0], grays[^1]));
        Assert.InRange(grays[20], 100, 155);
    }

    /// <summary>Transparent pixels have no colour that could bleed.</summary>
    [Fact]
    public void The_mean_of_red_and_nothing_is_half_transparent_red()
    {
        using var source = Bitmap(2, 1, 0xFFFF0000, 0x00000000);
        using var small = BitmapScaling.Averaged(source, new PixelSize(1, 1));

        Assert.Equal(0x80800000u, small[0, 0]);
    }

    private static SoftwareBitmap Bitmap(int width, int height, params uint[] pixels)
    {
        var bitmap = new SoftwareBitmap(new PixelSize(width, height), new Vector(96, 96));
        for (var y = 0; y < height; y++) pixels.AsSpan(y * width, width).CopyTo(bitmap.Row(y));
        return bitmap;
    }
}
