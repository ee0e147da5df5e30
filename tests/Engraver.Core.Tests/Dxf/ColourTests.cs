using System.Runtime.CompilerServices;
using Engraver.Core.Drawings;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

public class ColourTests
{
    private static readonly (int, object)[] s_layers =
    [
        (0, "LAYER"), (2, "RED"), (62, 1), (0, "LAYER"), (2, "OFF"), (62, -5), (0, "LAYER"), (2, "TRUE"), (62, 3), (420, 0x123456), (0, "LAYER"), (2, "GREEN"), (62, 3),
    ];

    private static readonly (int, object)[] s_ends = [(10, 0.0), (20, 0.0), (11, 1.0), (21, 0.0)];

    [Fact]
    public void Layers_have_their_colour_also_when_they_are_off()
    {
        var layers = Drawing([]).Layers.ToDictionary(layer => layer.Name);

        Assert.Equal((1, true), (layers["RED"].Colour.Index, layers["RED"].On));
        Assert.Equal((5, false), (layers["OFF"].Colour.Index, layers["OFF"].On));
        Assert.Equal(0x123456u, layers["TRUE"].Colour.Rgb);
        Assert.Equal(7, layers["0"].Colour.Index);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Entities_have_an_index_a_true_colour_or_that_of_their_layer(bool binary)
    {
        var text = Text([], [.. Line("RED"), .. Line("RED", (62, 4)), .. Line("RED", (62, 4), (420, 0xFF8000)), .. Line("TRUE", (62, 256)), .. Line("RED", (62, 0))]);
        var drawing = DxfReading.Of(binary ? text.ToBinary(oneByteCodes: false) : text.ToAscii());

        Assert.Empty(drawing.Diagnostics);
        Assert.Equal([1, 4, null, null, 7], Colours(drawing).Select(colour => colour.Index));
        Assert.Equal([null, null, 0xFF8000u, 0x123456u, null], Colours(drawing).Select(colour => colour.Rgb));
    }

    [Fact]
    public void By_block_goes_through_two_nested_inserts()
    {
        var inner = Block("A", [.. Line("0", (62, 0)), .. Line("0")]);
        var outer = Block("B", Insert("A", "0", (62, 0)));

        Assert.Equal([6, 1], Indices([.. inner, .. outer], Insert("B", "RED", (62, 6))));
        Assert.Equal([1, 1], Indices([.. inner, .. outer], Insert("B", "RED")));
        Assert.Equal([7, 3], Indices([.. inner, .. outer], Insert("B", "GREEN", (62, 0))));
    }

    [Fact]
    public void By_block_under_an_insert_by_layer_takes_the_layer_of_the_insert_and_not_its_own()
    {
        var blocks = Block("A", [.. Line("GREEN", (62, 0)), .. Line("GREEN"), .. Line("0"), .. Line("0", (62, 2))]);

        Assert.Equal([1, 3, 1, 2], Indices(blocks, Insert("A", "RED")));
    }

    [Fact]
    public void A_nested_insert_with_a_colour_of_its_own_hides_the_outer_one()
    {
        var blocks = Block("A", Line("0", (62, 0)));

        Assert.Equal([4], Indices([.. blocks, .. Block("B", Insert("A", "0", (62, 4)))], Insert("B", "RED", (62, 6))));
        Assert.Equal([3], Indices([.. blocks, .. Block("B", Insert("A", "GREEN"))], Insert("B", "RED", (62, 6))));
    }

    [Fact]
    public void Junk_for_a_true_colour_costs_nobody_an_entity()
    {
        var drawing = Drawing([], Line("RED", (420, "blue")));

        Assert.Equal(1, drawing.ColourOf(0).Index);
    }

    [Fact]
    public void A_row_of_the_entity_column_stays_small() => Assert.Equal(40, Unsafe.SizeOf<DrawingEntity>());

    private static (int, object)[] Line(string layer, params (int, object)[] more) => [(0, "LINE"), (8, layer), .. more, .. s_ends];

    private static (int, object)[] Insert(string block, string layer, params (int, object)[] more) => [(0, "INSERT"), (8, layer), (2, block), .. more, (10, 0.0), (20, 0.0)];

    private static (int, object)[] Block(string name, (int, object)[] content) => [(0, "BLOCK"), (2, name), (10, 0.0), (20, 0.0), .. content, (0, "ENDBLK")];

    private static DxfText Text((int, object)[] blocks, (int, object)[] entities) =>
        new DxfText().Header("AC1018", 4).Section("TABLES", s_layers).Section("BLOCKS", blocks).Section("ENTITIES", entities).End();

    private static Drawing Drawing((int, object)[] blocks, params (int, object)[] entities) => DxfReading.Of(Text(blocks, entities));

    private static IEnumerable<int?> Indices((int, object)[] blocks, (int, object)[] entities) => Colours(Drawing(blocks, entities)).Select(colour => colour.Index);

    private static IEnumerable<DrawingColour> Colours(Drawing drawing) => Enumerable.Range(0, drawing.Entities.Count).Select(drawing.ColourOf);
}
