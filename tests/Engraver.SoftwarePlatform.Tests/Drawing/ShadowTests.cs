using Avalonia;
using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

public class ShadowTests
{
    private static readonly RoundedRect s_box = new(new Rect(40, 40, 120, 80), 16);

    [Fact]
    public void A_hard_shadow_is_the_box_moved_and_grown()
    {
        using var picture = new Picture(220, 180).Draw(c => c.DrawRectangle(Picture.Brush(Colors.White), null, new RoundedRect(s_box.Rect), BoxShadows.Parse("10 20 0 5 Black")));

        Near.Equal(Colors.Black, picture.Color(172, 144));
        Assert.Equal(0, picture.Alpha(176, 144));
        Assert.Equal(Colors.White, picture.Color(50, 50));
    }

    [Fact]
    public void A_soft_shadow_has_half_its_strength_at_its_border()
    {
        using var picture = new Picture(220, 180).Draw(c => c.DrawRectangle(null, null, s_box, BoxShadows.Parse("0 0 24 0 Black")));

        Near.Equal(127, picture.Alpha(160, 80), 20);
        Assert.InRange(picture.Alpha(172, 80), 1, 40);
        Assert.Equal(0, picture.Alpha(190, 80));
    }

    [Fact]
    public void Under_a_box_that_is_not_opaque_the_shadow_is_cut_out()
    {
        using var picture = new Picture(220, 180).Draw(c => c.DrawRectangle(Picture.Brush(Color.FromArgb(10, 255, 255, 255)), null, s_box, BoxShadows.Parse("0 0 24 0 Black")));

        Assert.Equal(10, picture.Alpha(100, 80));
    }

    [Fact]
    public void There_is_no_seam_between_an_opaque_box_and_its_shadow_of_the_same_color()
    {
        using var picture = new Picture(220, 180, Colors.White).Draw(c => c.DrawRectangle(Picture.Brush(Colors.Black), null, s_box, BoxShadows.Parse("0 0 20 8 Black")));

        // From the middle of the box through its round corner outwards, it only gets brighter.
        var last = -1;
        for (var i = 0; i < 45; i++)
        {
            var bright = picture.Color(60 - i, 60 - i).R;
            Assert.True(bright >= last, $"seam at {60 - i}: {bright} after {last}");
            last = bright;
        }
    }

    [Fact]
    public void An_inset_shadow_darkens_the_inside_along_the_border()
    {
        using var picture = new Picture(220, 180).Draw(c => c.DrawRectangle(Picture.Brush(Colors.White), null, s_box, BoxShadows.Parse("inset 0 0 16 2 Black")));

        Near.Equal(Colors.White, picture.Color(100, 80));
        Assert.InRange((int)picture.Color(41, 80).R, 0, 130);
        Assert.Equal(0, picture.Alpha(38, 80));
    }

    /// <summary>A blur moves darkness but adds none: the sum over the picture stays the area.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    [InlineData(8)]
    [InlineData(24)]
    public void A_blurred_shadow_has_the_area_of_its_box(int radius)
    {
        var box = new RoundedRect(new Rect(20, 80, 60, 40)); // its shadow is beside it
        using var picture = new Picture(260, 200).Draw(c => c.DrawRectangle(null, null, box, BoxShadows.Parse($"120 0 {radius} 0 Black")));

        Near.Equal(60 * 40, picture.Area(), 60 * 40 * 0.015);
        Near.Equal(60 * 40, Enumerable.Range(0, 200).Sum(y => Enumerable.Range(100, 140).Sum(x => picture.Alpha(x, y))) / 255.0, 60 * 40 * 0.015);
    }

    [Fact]
    public void A_long_box_has_the_same_shadow_as_a_short_one_at_its_ends()
    {
        var shadows = BoxShadows.Parse("3 5 18 2 Black");
        using var shortBox = new Picture(700, 120).Draw(c => c.DrawRectangle(null, null, new RoundedRect(new Rect(30, 30, 90, 60), 10), shadows));
        using var longBox = new Picture(700, 120).Draw(c => c.DrawRectangle(null, null, new RoundedRect(new Rect(30, 30, 600, 60), 10), shadows));

        for (var y = 0; y < 120; y++)
        {
            for (var x = 0; x < 70; x++)
                Assert.True(Math.Abs(shortBox.Alpha(x, y) - longBox.Alpha(x, y)) <= 1, $"{x},{y}: {shortBox.Alpha(x, y)} and {longBox.Alpha(x, y)}");
        }
    }
}
