using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using static Engraver.TestKit.LinetypeDrawing;

namespace Engraver.Core.Tests.Dxf;

public class LineStyleTests
{
    [Fact]
    public void Linetypes_have_their_patterns_and_scales()
    {
        var drawing = DxfReading.Of(Of([.. Line("0", 0, 0, 9, 0, (6, "dot"), (48, 0.25)), .. Line("0", 0, 1, 9, 1), (0, "LWPOLYLINE"), (8, "HIDDEN"), (90, 2), (70, 128), (10, 0.0), (20, 2.0), (10, 9.0), (20, 2.0)]));

        Assert.Equal(["ByLayer", "ByBlock", "Continuous", "DASHED", "DOT", "GAS"], drawing.Linetypes.Select(linetype => linetype.Name).Take(6));
        Assert.Equal([2.0, -1.0, 0.0, -1.0], drawing.Linetypes[4].Elements);
        Assert.Equal(4.0, drawing.Linetypes[4].PatternLength);
        Assert.Equal([false, true], drawing.Linetypes.Skip(4).Take(2).Select(linetype => linetype.HasShapes));
        Assert.Equal(2.0, drawing.LinetypeScale);
        Assert.Equal([4, Linetype.Continuous, 3], Enumerable.Range(0, 3).Select(drawing.LinetypeOf));
        Assert.Equal([new LineStyle(4, 0.25, false), LineStyle.ByLayer, new LineStyle(Linetype.ByLayer, 1.0, true)], Enumerable.Range(0, 3).Select(entity => drawing.LineStyles[drawing.Entities[entity].LineStyle]));
    }

    /// <summary>"By block" is the linetype of the insert, and of the insert's layer where that is by layer.</summary>
    [Theory]
    [InlineData("HIDDEN", "", "DASHED")]
    [InlineData("HIDDEN", "DOT", "DOT")]
    [InlineData("0", "BYBLOCK", "Continuous")]
    [InlineData("0", "", "Continuous")]
    public void By_block_is_the_linetype_of_the_insert(string layer, string linetype, string expected)
    {
        var drawing = DxfReading.Of(Of(Insert("HOLE", 0, 0, layer, linetype.Length > 0 ? [(6, linetype)] : [])));

        Assert.Equal(expected, drawing.Linetypes[drawing.LinetypeOf(0)].Name);
    }

    [Fact]
    public void Curves_and_points_know_their_blocks_and_inserts_their_places()
    {
        var drawing = DxfReading.Of(Of([.. Line("0", 0, 0, 9, 0), .. Insert("BRACKET", 100, 50, "0", (41, 2.0), (42, 2.0), (70, 2), (44, 40.0)), .. Insert("MARK", 7, 8)]));

        Assert.Equal(["", "BRACKET", "BRACKET/HOLE", "BRACKET/HOLE", "BRACKET", "BRACKET/HOLE", "BRACKET/HOLE"], Enumerable.Range(0, drawing.Entities.Count).Select(entity => PathOf(drawing, drawing.BlockPathOf(entity))));
        Assert.Equal(["BRACKET/HOLE", "BRACKET/HOLE", "MARK"], drawing.Points.Select(point => PathOf(drawing, point.BlockPath)));
        Assert.Equal([("BRACKET", 100, 50), ("BRACKET/HOLE", 120, 50), ("BRACKET", 140, 50), ("BRACKET/HOLE", 160, 50), ("MARK", 7, 8)], drawing.Inserts.Select(insert => (PathOf(drawing, insert.Path), (int)insert.Position.X, (int)insert.Position.Y)));
        Assert.Equal([0, 1, 0, 3, 0], drawing.Inserts.Select(insert => insert.Around));
        Assert.Equal(["DOT", "DASHED", "Continuous"], Enumerable.Range(1, 3).Select(entity => drawing.Linetypes[drawing.LinetypeOf(entity)].Name));
        Assert.True(drawing.HasAllInserts);
    }

    [Fact]
    public void Edits_of_all_curves_of_an_insert_take_its_place_along()
    {
        var drawing = DxfReading.Of(Of([.. Insert("BRACKET", 100, 50), .. Insert("HOLE", 0, 0)]));

        Assert.True(DrawingEdit.TryTransform(drawing, [0, 1, 2], Transform2D.Move(new Vector2D(1.0, 2.0)), out var moved));
        Assert.Equal([(101.0, 52.0), (111.0, 52.0), (0.0, 0.0)], Places(moved));
        Assert.True(DrawingEdit.TryTransform(drawing, [0, 1], Transform2D.Move(new Vector2D(1.0, 2.0)), out var part));
        Assert.Equal(Places(drawing), Places(part));
        Assert.True(DrawingEdit.TryCopy(drawing, [0, 1, 2, 3], Transform2D.Move(new Vector2D(0.0, 10.0)), out var copied));
        Assert.Equal([(100.0, 50.0), (110.0, 50.0), (0.0, 0.0), (100.0, 60.0), (110.0, 60.0)], Places(copied));
        Assert.Equal([1, 2, 2, 3, 3, 4, 5, 5, 3], Enumerable.Range(0, copied.Entities.Count).Select(entity => copied.Entities[entity].Insert));
        Assert.Equal(4, copied.Inserts[4].Around);
        Assert.Equal([false, false, true], DrawingEdit.Erase(drawing, [3, 4]).Inserts.Select(insert => insert.IsErased));
    }

    private static IEnumerable<(double X, double Y)> Places(Drawing drawing) => drawing.Inserts.Select(insert => (insert.Position.X, insert.Position.Y));

    private static string PathOf(Drawing drawing, int path) => path == 0 ? "" : string.Join('/', ((string[])[PathOf(drawing, drawing.BlockPaths[path].Around), drawing.Blocks[drawing.BlockPaths[path].Block]]).Where(name => name.Length > 0));
}
