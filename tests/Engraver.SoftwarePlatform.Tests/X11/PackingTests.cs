using Avalonia;
using Engraver.SoftwarePlatform.Windows;
using Engraver.SoftwarePlatform.X11;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.Tests.X11;

public sealed class PackingTests
{
    [Fact]
    public void An_icon_is_its_size_and_its_pixels_not_premultiplied()
    {
        var icon = new IconPicture(new PixelSize(2, 2), [0xFF102030, 0x80402010, 0x00000000, 0x01010101]);

        Assert.Equal([2, 2, unchecked((nint)0xFF102030u), unchecked((nint)0x80804020u), 0, 0x01FFFFFF], NetWmIcon.Pack(icon));
    }

    [Fact]
    public void A_cursor_is_light_where_it_is_light_and_there_where_it_is_opaque()
    {
        var pixels = Enumerable.Repeat(0xFF000000u, 10).ToArray();
        (pixels[0], pixels[8]) = (0xFFFFFFFF, 0x20FFFFFF);
        var (light, mask) = CursorMasks.Create(new IconPicture(new PixelSize(10, 1), pixels));

        Assert.Equal([0b0000_0001, 0], light);
        Assert.Equal([0xFF, 0b0000_0010], mask);
    }

    [Theory]
    [InlineData("Xft.dpi:\t144\n", 1.5)]
    [InlineData("Xft.antialias: 1\nXft.dpi: 192\nOther: 3", 2.0)]
    [InlineData("Xft.dpi: nonsense", 1.0)]
    [InlineData("Xft.dpi: 5", 1.0)]
    [InlineData(null, 1.0)]
    public void The_display_s_density_gives_the_scale(string? resources, double scale) => Assert.Equal(scale, XftDpi.ScaleOf(resources));

    [Fact]
    public void Limits_are_in_pixels_and_rounded_up()
    {
        var hints = new SizeHints { Size = new PixelSize(300, 200) };
        hints.SetLimits(new Size(100.5, 60), new Size(double.PositiveInfinity, 400), 1.5);
        var packed = hints.Pack();

        Assert.Equal([48, 0, 0, 300, 200, 151, 90, 32767, 600], packed[..9]);
        Assert.Equal(18, packed.Length);
    }

    [Fact]
    public void A_window_of_fixed_size_is_its_own_least_and_greatest()
    {
        var hints = new SizeHints { Size = new PixelSize(300, 200), CanResize = false, Position = new PixelPoint(5, 6) };

        Assert.Equal([52, 5, 6, 300, 200, 300, 200, 300, 200], hints.Pack()[..9]);
    }

    [Theory]
    [InlineData(4u, 0, 1)]
    [InlineData(5u, 0, -1)]
    [InlineData(6u, 1, 0)]
    [InlineData(7u, -1, 0)]
    public void Buttons_four_to_seven_are_wheels(uint button, double x, double y) => Assert.Equal(new Vector(x, y), XButtons.WheelOf(button));
}
