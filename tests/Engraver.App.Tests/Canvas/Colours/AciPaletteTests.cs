using Engraver.App.Canvas.Colours;

namespace Engraver.App.Tests.Canvas.Colours;

public class AciPaletteTests
{
    [Theory]
    [InlineData(1, 0xFFFF0000)]
    [InlineData(2, 0xFFFFFF00)]
    [InlineData(3, 0xFF00FF00)]
    [InlineData(4, 0xFF00FFFF)]
    [InlineData(5, 0xFF0000FF)]
    [InlineData(6, 0xFFFF00FF)]
    [InlineData(8, 0xFF808080)]
    [InlineData(10, 0xFFFF0000)]
    [InlineData(11, 0xFFFF7F7F)]
    [InlineData(13, 0xFFA55252)]
    [InlineData(21, 0xFFFF9F7F)]
    [InlineData(24, 0xFF7F1F00)]
    [InlineData(28, 0xFF260900)]
    [InlineData(30, 0xFFFF7F00)]
    [InlineData(50, 0xFFFFFF00)]
    [InlineData(90, 0xFF00FF00)]
    [InlineData(150, 0xFF007FFF)]
    [InlineData(170, 0xFF0000FF)]
    [InlineData(240, 0xFFFF003F)]
    [InlineData(249, 0xFF261317)]
    [InlineData(250, 0xFF333333)]
    [InlineData(255, 0xFFFFFFFF)]
    public void Indexes_have_the_colours_of_AutoCAD(int index, uint colour) => Assert.Equal(colour, AciPalette.ColourOf(index, 0xFFFFFFFF));

    [Theory]
    [InlineData(0xFFFFFFFF)]
    [InlineData(0xFF000000)]
    public void Seven_is_white_on_dark_and_black_on_light(uint foreground) => Assert.Equal(foreground, AciPalette.ColourOf(7, foreground));

    [Fact]
    public void All_hues_are_there_and_no_other_index_is()
    {
        Assert.Equal(24, Enumerable.Range(1, 24).Select(hue => AciPalette.ColourOf(hue * 10, 0)).Distinct().Count());
        Assert.Throws<ArgumentOutOfRangeException>(() => AciPalette.ColourOf(256, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => AciPalette.ColourOf(-1, 0));
    }
}
