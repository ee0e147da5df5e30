using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>POINT is stored with its position, layer, colour and visibility, and counted as before.</summary>
public class PointTests
{
    [Fact]
    public void A_point_keeps_its_place_layer_and_colour()
    {
        var drawing = DxfReading.Entities((0, "POINT"), (8, "NOTES"), (62, 3), (10, 1.5), (20, -2.0), (30, 7.0), (0, "POINT"), (60, 1), (10, 4.0), (20, 5.0), (0, "POINT"), (67, 1), (10, 9.0), (20, 9.0));

        Assert.Equal([new(new Vector3D(1.5, -2.0, 7.0), 1, DrawingColour.FromCode62(3), Hidden: false), new PlacedPoint(new Vector3D(4.0, 5.0, 0.0), 0, DrawingColour.ByLayer, Hidden: true)], drawing.Points.Select(point => point with { SourceLine = 0 }));
        Assert.Equal((2, 2, 2), (drawing.Balance.Points, drawing.Balance.Construction, drawing.Balance.EntityCounts["POINT"]));
        Assert.Empty(UnusedContent.Find(drawing));
    }

    /// <summary>Points are only shown: one that cannot be placed has no effect, and is counted among the entities that SAVEAS does not write.</summary>
    [Theory]
    [InlineData(10, "1.2.3")]
    [InlineData(20, "x")]
    [InlineData(10, "1e200")]
    [InlineData(1000, "10 alone")]
    public void A_point_without_a_place_is_counted_and_not_kept(int code, string value)
    {
        var drawing = DxfReading.Entities((0, "POINT"), (code, value), (code == 20 ? 10 : 20, 1.0), (0, "POINT"), (62, 1), (62, 2), (10, 3.0), (10, 8.0), (20, 4.0));

        Assert.Equal([new Vector3D(3.0, 4.0, 0.0)], drawing.Points.Select(point => point.Position));
        Assert.Equal((2, 0), (drawing.Balance.Points, drawing.Balance.Refused.Count));
        Assert.Equal([("POINT", 1)], UnusedContent.Find(drawing));
    }

    /// <summary>A block of a point on layer 0 by block, twice in a row 10 apart, turned by 90 degrees and twice as large, in an insert on layer CUT of
    /// colour 5.</summary>
    [Fact]
    public void Points_of_blocks_stand_where_their_copies_are()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4)
            .Section("BLOCKS", (0, "BLOCK"), (2, "B"), (10, 1.0), (20, 0.0), (0, "POINT"), (8, "0"), (62, 0), (10, 4.0), (20, 0.0), (0, "ENDBLK"))
            .Section("ENTITIES", (0, "INSERT"), (8, "CUT"), (62, 5), (2, "B"), (10, 100.0), (20, 50.0), (41, 2.0), (42, 2.0), (50, 90.0), (70, 2), (44, 10.0)).End());

        Assert.Equal([(100.0, 56.0), (100.0, 66.0)], drawing.Points.Select(point => (Math.Round(point.Position.X, 9), Math.Round(point.Position.Y, 9))));
        Assert.All(drawing.Points, point => Assert.Equal(("CUT", 5), (drawing.Layers[point.Layer].Name, point.Colour.Index)));
        Assert.Equal(2, drawing.Balance.Points);
    }

    /// <summary>A million and one: the first million are stored, the rest is counted and reported.</summary>
    [Fact]
    public void More_than_a_million_points_are_counted()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4)
            .Section("BLOCKS", (0, "BLOCK"), (2, "B"), (10, 0.0), (20, 0.0), (0, "POINT"), (10, 0.0), (20, 0.0), (0, "ENDBLK"))
            .Section("ENTITIES", (0, "INSERT"), (2, "B"), (10, 0.0), (20, 0.0), (70, 1000), (71, 1001), (44, 1.0), (45, 1.0), (0, "POINT"), (10, 5.0), (20, 5.0)).End());

        Assert.Equal((1, 1_001_001), (drawing.Points.Count, drawing.Balance.Points));
        Assert.Equal([("POINT", 1_001_000)], UnusedContent.Find(drawing));
    }
}
