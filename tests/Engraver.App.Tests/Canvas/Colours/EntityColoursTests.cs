using Engraver.App.Canvas.Colours;
using Engraver.Core.Drawings;
using Engraver.TestKit;

namespace Engraver.App.Tests.Canvas.Colours;

public class EntityColoursTests
{
    private static readonly DrawingColour s_red = DrawingColour.FromCode62(1);
    private static readonly DrawingColour s_orange = DrawingColour.FromCode420(0xFF8000);

    [Fact]
    public void True_colours_follow_the_palette_and_are_shared()
    {
        var colours = EntityColours.From(4, entity => entity == 0 ? s_red : entity == 3 ? DrawingColour.FromCode420(0x123456) : s_orange);

        var palette = colours.PaletteFor(CanvasTheme.Dark);

        Assert.Equal(258, palette.Length);
        Assert.Equal(1, colours[0]);
        Assert.Equal(colours[1], colours[2]);
        Assert.Equal(0xFFFF8000, palette[colours[1]]);
        Assert.Equal(0xFF123456, palette[colours[3]]);
    }

    [Fact]
    public void Layers_colour_their_entities_and_unknown_ones_are_in_the_foreground()
    {
        var drawing = new DrawingBuilder().Line(0.0, 0.0, 1.0, 0.0).OnLayer(new Layer("CUT", true, false, true) { Colour = s_red }).Line(0.0, 0.0, 1.0, 0.0).Build();

        var colours = EntityColours.From(drawing);

        Assert.Equal((7, 1), (colours[0], colours[1]));
        Assert.Equal(7, colours[2]);
        Assert.Equal(7, EntityColours.AllForeground[0]);
    }

    [Theory]
    [InlineData(false, 0xFFFFFFFF, 0xFFFF0000, 0xFFFF8000)]
    [InlineData(true, 0xFF909498, 0xFF901418, 0xFF905418)]
    public void What_lies_on_a_locked_layer_is_faded_half_into_the_background(bool isLocked, uint white, uint red, uint orange)
    {
        var drawing = new DrawingBuilder().OnLayer(LayerOf("A", DrawingColour.Foreground)).Line(0, 0, 1, 0).OnLayer(LayerOf("B", s_red)).Line(0, 1, 1, 1).OnLayer(LayerOf("C", s_orange)).Line(0, 2, 1, 2).Build();
        var (colours, palette) = (EntityColours.From(drawing), EntityColours.From(drawing).PaletteFor(CanvasTheme.Dark));

        Assert.Equal([white, red, orange], new[] { 0, 1, 2 }.Select(entity => palette[colours[entity]]));
        Assert.Equal(isLocked ? 259 : 257, palette.Length);

        Layer LayerOf(string name, DrawingColour colour) => new(name, true, false, true) { Locked = isLocked, Colour = colour };
    }
}
