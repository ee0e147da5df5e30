using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Records outside of sections, blocks that are missing in the file: every loss is reported.</summary>
public class LooseRecordTests
{
    private static readonly (int, object)[] s_line = [(0, "LINE"), (8, "0"), (10, 0), (20, 0), (11, 3), (21, 4)];

    [Fact]
    public void Entities_behind_an_ENDSEC_too_many_are_the_drawings()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("ENTITIES", s_line).Add(s_line).Add((0, "ENDSEC")).End());

        Assert.Equal((2, 2), (drawing.Balance.Read, drawing.Balance.Cut));
        Assert.Equal(["DXF0042"], DxfReading.Ids(drawing));
    }

    [Fact]
    public void Entities_ahead_of_the_first_section_are_the_drawings_and_without_any_section_it_is_no_drawing()
    {
        var drawing = DxfReading.Of(new DxfText().Add(s_line).Header("AC1015", 4).End());

        Assert.Equal((1, "DXF0042"), (drawing.Balance.Cut, Assert.Single(DxfReading.Ids(drawing))));
        Assert.Equal(["DXF0002"], DxfReading.Ids(DxfReading.Of(new DxfText().Add(s_line).End())));
    }

    /// <summary>Some programs write the drawing into the block that is model space. Its inserts may need blocks that follow later.</summary>
    [Theory]
    [InlineData("*Model_Space", 2)]
    [InlineData("$MODEL_SPACE", 2)]
    [InlineData("*Paper_Space", 0)]
    public void What_stands_in_the_block_of_model_space_is_the_drawings(string name, int cut)
    {
        var file = new DxfText().Header("AC1015", 4)
            .Section("BLOCKS", [.. OddDrawings.Block(name, [.. s_line, .. OddDrawings.Insert("A", 2.0)]), .. OddDrawings.Block("A", s_line)])
            .Section("ENTITIES", s_line).End();
        var drawing = DxfReading.Of(file);

        Assert.Equal((cut + 1, cut + 1, cut + 1), (drawing.Balance.Read, drawing.Balance.Cut, drawing.Entities.Count));
        Assert.Equal(cut > 0 ? ["DXF0043"] : [], DxfReading.Ids(drawing));
    }

    [Theory]
    [InlineData("LINE", 0, 1)]
    [InlineData("LINE", 1, 0)]
    [InlineData("BODY", 0, 0)]
    [InlineData("TEXT", 0, 1)]
    public void The_block_of_model_space_is_only_told_of_when_something_in_it_was_taken(string type, int paper, int told)
    {
        (int, object)[] content = [(0, type), (67, paper), (10, 0), (20, 0), (11, 3), (21, 4)];
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("BLOCKS", OddDrawings.Block("*Model_Space", content)).Section("ENTITIES", s_line).End());

        Assert.Equal(told, drawing.Diagnostics.Count(one => one.Id == "DXF0043" && one.Message.Contains(" contains 1 entity, read as part of the drawing.", StringComparison.Ordinal)));
        Assert.Empty(DxfReading.Of(new DxfText().Header("AC1015", 4).Section("BLOCKS", OddDrawings.Block("*Model_Space", [])).Section("ENTITIES", s_line).End()).Diagnostics);
    }

    [Fact]
    public void An_ENDSEC_inside_a_block_does_not_spill_its_content_into_the_drawing()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4)
            .Section("BLOCKS", [(0, "BLOCK"), (2, "A"), (10, 0), (20, 0), .. s_line]).Add([.. s_line, (0, "ENDBLK"), .. OddDrawings.Block("B", s_line), (0, "ENDSEC")])
            .Section("ENTITIES", [.. OddDrawings.Insert("A", 2.0), .. OddDrawings.Insert("B", 2.0)]).End());

        Assert.Equal((2, 2, 3), (drawing.Balance.Read, drawing.Balance.Cut, drawing.Entities.Count));
        Assert.Equal(["DXF0042"], DxfReading.Ids(drawing));
    }

    [Theory]
    [InlineData(4, 0)]
    [InlineData(12, 0)]
    [InlineData(36, 1)]
    public void An_external_reference_is_told_unless_its_drawing_is_bound(int flags, int lines)
    {
        (int, object)[] content = lines == 0 ? [] : s_line;
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("BLOCKS", [(0, "BLOCK"), (2, "X"), (70, flags), (1, "other.dwg"), .. content, (0, "ENDBLK")]).Section("ENTITIES", OddDrawings.Insert("X", 1.0)).End());

        Assert.Equal((lines, 1 - lines), (drawing.Balance.Cut, drawing.Balance.Refused.Count(one => one.DiagnosticId == "DXF0017")));
    }

    [Theory]
    [InlineData("NaN", 0, "DXF0007")]
    [InlineData("5,5", 1, "DXF0037")]
    public void A_bad_number_in_an_outline_that_is_cut_is_told(string number, int cut, string id)
    {
        (int, object)[] hatch = [(0, "HATCH"), (92, 1), (72, 1), (10, 0), (20, 0), (11, number), (21, 0), (72, 1), (10, 1), (20, 1), (11, 2), (21, 2), (75, 0)];
        var file = DxfText.WithEntities(hatch).ToAscii();
        var drawing = DxfReading.Of(file, new DxfReadOptions(Cut: CutChoice.Hatch));

        Assert.Equal((cut, 1 - cut), (drawing.Balance.Cut, drawing.Balance.Refused.Count));
        Assert.Equal([id], DxfReading.Ids(drawing));
        Assert.Empty(DxfReading.Of(file).Diagnostics); // construction is not cut
    }

    [Theory]
    [InlineData("\n\r", "")]
    [InlineData("\n", "+")]
    public void Uncommon_line_ends_and_signed_codes_read_like_others(string lineEnd, string sign)
    {
        var lines = System.Text.Encoding.UTF8.GetString(DxfText.WithEntities(s_line).ToAscii()).Split('\n')[..^1];
        var drawing = DxfReading.Of(string.Concat(lines.Select((line, i) => (i % 2 == 0 ? sign + line.Trim() : line) + lineEnd)));

        Assert.Equal((1, 5.0), (drawing.Balance.Cut, DrawingSummary.From(drawing).Length.Total));
        Assert.Empty(drawing.Diagnostics);
    }

    [Fact]
    public void The_first_releases_of_DWG_are_recognised() => Assert.Equal(["DXF0004"], DxfReading.Ids(DxfReading.Of([.. "MC0.0\0"u8, 0, 1, 2])));
}
