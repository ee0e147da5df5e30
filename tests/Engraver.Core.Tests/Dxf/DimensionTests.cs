using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>A dimension is drawn by its own block (DXF reference, "DIMENSION").</summary>
public class DimensionTests
{
    private static readonly (int Code, object Value)[] s_block =
    [
        (0, "BLOCK"), (2, "*D1"), (10, 0.0), (20, 0.0),
        (0, "LINE"), (8, "0"), (10, 1.0), (20, 2.0), (11, 11.0), (21, 2.0),
        (0, "MTEXT"), (8, "0"), (10, 6.0), (20, 3.0), (40, 2.5), (1, "10"),
        (0, "ENDBLK"),
    ];

    [Fact]
    public void Its_lines_and_its_text_are_where_the_block_has_them()
    {
        var drawing = Read(CutChoice.Dimension, (0, "DIMENSION"), (8, "DIM"), (2, "*D1"), (10, 5.0), (20, 7.0), (70, 32));

        var line = Assert.Single(DxfReading.Parts(drawing));
        Assert.Equal((1.0, 2.0, 11.0, 2.0), (line.A, line.B, line.D, line.E));
        Assert.Equal("DIM", drawing.Layers[drawing.Entities[0].Layer].Name);
        var text = Assert.Single(drawing.Texts);
        Assert.Equal(("10", 6.0, 3.0), (text.Content, text.Position.X, text.Position.Y));
        Assert.Equal((1, 1, 0), (drawing.Balance.Read, drawing.Balance.Cut, drawing.Balance.Construction));
    }

    [Fact]
    public void Group_12_moves_it()
    {
        var drawing = Read(CutChoice.Dimension, (0, "DIMENSION"), (8, "DIM"), (2, "*D1"), (12, 100.0), (22, 50.0));

        var line = Assert.Single(DxfReading.Parts(drawing));
        Assert.Equal((101.0, 52.0, 111.0, 52.0), (line.A, line.B, line.D, line.E));
    }

    [Fact]
    public void Without_the_choice_it_is_counted()
    {
        var drawing = Read(CutChoice.None, (0, "DIMENSION"), (8, "DIM"), (2, "*D1"));

        Assert.Equal((0, 1, 0), (drawing.Balance.Cut, drawing.Balance.Construction, drawing.Texts.Count));
        Assert.Equal("DIMENSION", Assert.Single(drawing.Construction).Type);
    }

    [Theory]
    [InlineData("*D2", "DXF0017")]
    [InlineData(null, "DXF0008")]
    public void Without_its_block_it_is_refused_by_name(string? block, string id)
    {
        var drawing = Read(CutChoice.Dimension, [(0, "DIMENSION"), (8, "DIM"), .. block is null ? [] : new (int, object)[] { (2, block) }]);

        var refused = Assert.Single(drawing.Balance.Refused);
        Assert.Equal(("DIMENSION", id), (refused.Type, refused.DiagnosticId));
    }

    private static Drawing Read(CutChoice cut, params ReadOnlySpan<(int Code, object Value)> entities) =>
        DxfReading.Of(new DxfText().Header("AC1015", 4).Section("BLOCKS", s_block).Section("ENTITIES", entities).End().ToAscii(), DxfReadOptions.Default with { Cut = cut });
}
