using Engraver.Core.Drawings;

namespace Engraver.Core.Tests.Drawings;

public class DrawingColourTests
{
    private static readonly DrawingColour s_red = DrawingColour.FromCode62(1);
    private static readonly DrawingColour s_orange = DrawingColour.FromCode420(0xFF8000);

    [Fact]
    public void By_layer_takes_the_layer_and_by_block_the_insert()
    {
        Assert.Equal(1, DrawingColour.FromCode62(256).Resolved(s_red, s_orange).Index);
        Assert.Equal(0xFF8000u, DrawingColour.FromCode62(0).Resolved(s_red, s_orange).Rgb);
        Assert.Equal(5, DrawingColour.FromCode62(5).Resolved(s_red, s_orange).Index);
        Assert.Equal(7, DrawingColour.ByBlock.Resolved(s_red, DrawingColour.ByLayer).Index);
    }

    [Fact]
    public void A_layer_that_is_off_keeps_its_colour() => Assert.Equal(3, DrawingColour.FromCode62(-3).Index);

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(255)]
    [InlineData(256)]
    public void Code_62_comes_back_as_written(int code) => Assert.Equal(code, DrawingColour.FromCode62(code).Code62);

    [Fact]
    public void Black_as_a_true_colour_is_no_other_colour()
    {
        Assert.Equal(0u, DrawingColour.FromCode420(0).Rgb);
        Assert.Null(DrawingColour.FromCode420(0).Code62);
        Assert.Equal(DrawingColour.ByLayer, DrawingColour.FromCode62(int.MinValue));
    }
}
