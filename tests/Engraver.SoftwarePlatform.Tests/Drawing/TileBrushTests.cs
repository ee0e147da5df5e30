using Avalonia;
using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

public class TileBrushTests
{
    private static readonly Color s_green = Color.FromRgb(0, 255, 0);

    [Fact]
    public void An_image_fills_its_target()
    {
        using var picture = Filled(Stretch.Fill, TileMode.None, 80, 40);

        Assert.Equal(3200, picture.Area());
        Assert.Equal(Colors.Red, picture.Color(10, 10));
        Assert.Equal(s_green, picture.Color(70, 10));
        Assert.Equal(Colors.Blue, picture.Color(0, 39));
        Assert.Equal(Colors.White, picture.Color(79, 39));
    }

    [Fact]
    public void A_uniform_image_leaves_room_at_its_sides()
    {
        using var picture = Filled(Stretch.Uniform, TileMode.None, 80, 40);

        Assert.Equal(1600, picture.Area());
        Assert.Equal(Colors.Red, picture.Color(22, 10));
        Assert.Equal(0, picture.Alpha(19, 10));
    }

    [Fact]
    public void An_image_that_is_not_stretched_stands_in_the_middle()
    {
        using var picture = Filled(Stretch.None, TileMode.None, 40, 40);

        Assert.Equal(256, picture.Area());
        Assert.Equal(Colors.Red, picture.Color(12, 12));
    }

    [Fact]
    public void Tiles_repeat_with_their_distance()
    {
        using var picture = Filled(Stretch.Fill, TileMode.Tile, 64, 64, new RelativeRect(4, 4, 16, 16, RelativeUnit.Absolute));

        foreach (var (x, y) in new[] { (6, 6), (22, 6), (6, 38), (54, 54) })
            Assert.Equal(Colors.Red, picture.Color(x, y));
        Assert.Equal(Colors.White, picture.Color(1, 1));
        Assert.Equal(4096, picture.Area());
    }

    [Fact]
    public void Flipped_tiles_are_mirrored_at_their_borders()
    {
        using var picture = Filled(Stretch.Fill, TileMode.FlipXY, 32, 32, new RelativeRect(0, 0, 16, 16, RelativeUnit.Absolute));

        Assert.Equal(Colors.Red, picture.Color(2, 2));
        Assert.Equal(s_green, picture.Color(18, 2));
        Assert.Equal(Colors.Red, picture.Color(30, 30));
        Assert.Equal(Colors.White, picture.Color(17, 17));
    }

    [Fact]
    public void Part_of_an_image_can_be_the_source()
    {
        using var image = new TestImage(TestImage.FourColors(8));
        var brush = new TestImageBrush(image) { SourceRect = new RelativeRect(0.5, 0, 0.5, 0.5, RelativeUnit.Relative) };
        using var picture = new Picture(30, 30).Draw(c => c.DrawEllipse(brush, null, new Rect(0, 0, 30, 30)));

        Assert.Equal(s_green, picture.Color(15, 15));
        Near.Equal(Math.PI * 225, picture.Area(), 1.5);
    }

    private static Picture Filled(Stretch stretch, TileMode tileMode, int width, int height, RelativeRect? destination = null)
    {
        using var image = new TestImage(TestImage.FourColors(8));
        var brush = new TestImageBrush(image) { TileMode = tileMode, Stretch = stretch, DestinationRect = destination ?? RelativeRect.Fill };
        return new Picture(width, height).Draw(c => c.DrawRectangle(brush, null, new RoundedRect(new Rect(0, 0, width, height))));
    }
}
