using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>How every entity type is handled: cut, construction or refused.</summary>
public class EntityKindTests
{
    [Theory]
    [InlineData("XLINE")]
    [InlineData("RAY")]
    [InlineData("DIMENSION")]
    [InlineData("ARC_DIMENSION")]
    [InlineData("ACAD_TABLE")]
    [InlineData("ACAD_PROXY_ENTITY")]
    [InlineData("3DSOLID")]
    [InlineData("MESH")]
    [InlineData("MULTILEADER")]
    [InlineData("WIPEOUT")]
    [InlineData("IMAGE")]
    [InlineData("VIEWPORT")]
    [InlineData("TOLERANCE")]
    [InlineData("SHAPE")]
    [InlineData("POINT")]
    [InlineData("TEXT")]
    [InlineData("MTEXT")]
    [InlineData("ATTDEF")]
    [InlineData("HATCH")]
    [InlineData("MLINE")]
    [InlineData("LEADER")]
    [InlineData("HELIX")]
    [InlineData("SOLID")]
    [InlineData("TRACE")]
    [InlineData("3DFACE")]
    public void Construction_is_counted_and_harms_nothing_whatever_is_in_it(string type)
    {
        var drawing = DxfReading.Entities([(0, type), (8, "0"), (10, "junk"), (40, "NaN"), (70, "x"), .. OddDrawings.Arc]);

        Assert.Equal((2, 1, 1, 0), (drawing.Balance.Read, drawing.Balance.Cut, drawing.Balance.Construction, drawing.Balance.Refused.Count));
        Assert.Empty(drawing.Diagnostics);
    }

    [Theory]
    [InlineData("BODY")]
    [InlineData("REGION")]
    [InlineData("3DLINE")]
    [InlineData("NOVELTY_OF_2030")]
    [InlineData("LWPOLYLINES")]
    public void What_is_not_known_is_refused_by_name_and_line(string type)
    {
        var drawing = DxfReading.Entities([(0, type), (5, "2F"), .. OddDrawings.Arc]);

        var refused = Assert.Single(drawing.Balance.Refused);
        Assert.Equal((type, "2F", 19L, "DXF0012"), (refused.Type, refused.Handle, refused.Line, refused.DiagnosticId));
        Assert.Equal(1, drawing.Balance.Cut);
    }

    [Fact]
    public void A_foreign_number_is_told_wherever_it_stands()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4)
            .Section("BLOCKS", (0, "BLOCK"), (2, "B"), (0, "CIRCLE"), (10, "1,5"), (20, 0), (40, 1), (0, "ENDBLK"))
            .Section("ENTITIES", (0, "INSERT"), (2, "B"), (10, "2,5"), (20, 0), (0, "POLYLINE"), (0, "VERTEX"), (10, 0), (20, 0), (0, "VERTEX"), (10, "3,5"), (20, 0), (0, "SEQEND"), (0, "LWPOLYLINE"), (10, "4,5"), (20, 0), (10, 9), (20, 0))
            .End());

        Assert.Equal(4, DxfReading.Ids(drawing).Count(id => id == "DXF0037"));
        Assert.Equal([4.0, 3.5, 4.5], DxfReading.Parts(drawing).Select((part, i) => i == 1 ? part.D : part.A));
    }
}
