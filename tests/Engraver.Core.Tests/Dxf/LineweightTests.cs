using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using static Engraver.TestKit.LineweightDrawing;

namespace Engraver.Core.Tests.Dxf;

public class LineweightTests
{
    /// <summary>By layer, explicit, and by block: outside blocks that is the default.</summary>
    [Fact]
    public void Lineweights_are_resolved_in_millimetres_whatever_the_unit()
    {
        var drawing = DxfReading.Of(Of([.. Line("0", 0), .. Line("THICK", 1), .. Line("THICK", 2, (370, 18)), .. Line("THICK", 3, (370, -3)), .. Line("THICK", 4, (370, -2)), .. Line("0", 5, (370, 0)), .. Line("0", 6, (370, 999))], insUnits: 1));

        Assert.Equal([0.25, 0.5, 0.18, 0.25, 0.25, 0.0, 0.25], Widths(drawing));
        Assert.Equal([0.13, 0.5, 0.13], Widths(DxfReading.Of(Of([.. Line("0", 0), .. Line("THICK", 1), .. Line("NEW", 2)], defaultWeight: 13))));
    }

    /// <summary>"By block" is the lineweight of the insert, and of the insert's layer where that is by layer, through every block around it.</summary>
    [Theory]
    [InlineData("THICK", null, 0.5)]
    [InlineData("THICK", 35, 0.35)]
    [InlineData("0", null, 0.25)]
    [InlineData("0", -2, 0.25)]
    public void By_block_is_the_lineweight_of_the_insert(string layer, int? weight, double expected)
    {
        var drawing = DxfReading.Of(Of(Insert("OUTER", layer, weight is { } stated ? [(370, stated)] : [])));

        Assert.Equal([expected, expected, 0.7], Widths(drawing)); // by block, by block in a nested block by block, its own
    }

    [Fact]
    public void Polylines_have_their_constant_width_in_the_unit_of_the_drawing()
    {
        var drawing = DxfReading.Of(Of(
        [
            .. Polyline((43, 0.04), (10, 0.0), (20, 0.0), (10, 9.0), (20, 0.0)),
            .. Polyline((10, 0.0), (20, 0.0), (40, 0.04), (41, 0.04), (10, 9.0), (20, 0.0), (40, 0.0), (41, 0.0)),
            .. Polyline((43, 0.0), (10, 0.0), (20, 0.0), (40, 0.04), (41, 0.02), (10, 9.0), (20, 0.0)),
            .. Polyline((370, 35), (10, 0.0), (20, 0.0), (40, 0.0), (41, 0.0), (10, 9.0), (20, 0.0)),
            .. Polyline((70, 1), (10, 0.0), (20, 0.0), (40, 0.04), (41, 0.04), (10, 9.0), (20, 0.0), (10, 9.0), (20, 9.0), (40, 0.04), (41, 0.04)),
            (0, "POLYLINE"), (8, "0"), (66, 1), (40, 0.04), (41, 0.04), (0, "VERTEX"), (10, 0.0), (20, 5.0), (0, "VERTEX"), (10, 9.0), (20, 5.0), (41, 0.0), (0, "SEQEND"),
        ], insUnits: 1));

        Assert.Equal([1.016, 1.016, double.NaN, 0.35, double.NaN, 1.016], Widths(drawing).Select(width => Math.Round(width, 9)));
    }

    [Fact]
    public void Widths_of_polylines_are_scaled_with_blocks_placement_and_edits_and_lineweights_are_not()
    {
        var drawing = DxfReading.Of(Of([.. Insert("WIDE", "0", (41, 2.0), (42, 2.0)), .. Insert("WIDE", "0", (41, 2.0)), .. Insert("WIDE", "0", (41, -1.0), (50, 30.0)), .. Line("THICK", 0)]));

        Assert.Equal([2.4, double.NaN, 1.2, 0.5], Widths(drawing).Select(width => Math.Round(width, 9)));
        Assert.True(MappedDrawing.Try(drawing, Transform2D.ScaleFrom(default, 0.5), out var placed));
        Assert.Equal([1.2, double.NaN, 0.6, 0.5], Widths(placed).Select(width => Math.Round(width, 9)));
        Assert.True(DrawingEdit.TryTransform(drawing, [0, 3], Transform2D.ScaleFrom(default, 3.0), out var edited));
        Assert.Equal([7.2, double.NaN, 1.2, 0.5], Widths(edited).Select(width => Math.Round(width, 9)));
        Assert.True(DrawingEdit.TryCopy(drawing, [2], Transform2D.ScaleFrom(default, 2.0), out var copied));
        Assert.Equal([2.4, double.NaN, 1.2, 0.5, 2.4], Widths(copied).Select(width => Math.Round(width, 9)));
    }

    [Fact]
    public void Texts_know_their_lineweight()
    {
        var drawing = DxfReading.Of(Of([(0, "TEXT"), (8, "0"), (370, 35), (10, 0.0), (20, 0.0), (40, 5.0), (1, "A"), .. Insert("NAMED", "THICK")]));

        Assert.Equal([35, Lineweight.ByLayer], drawing.Texts.Select(text => text.Lineweight));
        Assert.Equal(50, drawing.Layers[drawing.Texts[1].Layer].Lineweight);
    }

    private static IEnumerable<double> Widths(Drawing drawing) => Enumerable.Range(0, drawing.Entities.Count).Select(drawing.LineWidthOf);
}
