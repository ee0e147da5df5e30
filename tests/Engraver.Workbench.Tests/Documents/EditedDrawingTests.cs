using System.Globalization;
using System.Text;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Dxf.Writing;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using static Engraver.TestKit.LinetypeDrawing;

namespace Engraver.Workbench.Tests.Documents;

public class EditedDrawingTests
{
    /// <summary>Blocks are written as their curves; operations that name them take the same curves of the written drawing.</summary>
    [Fact]
    public void A_written_drawing_keeps_linetypes_and_what_came_from_blocks()
    {
        var drawing = Read(Of([.. Line("HIDDEN", 0, 0, 9, 0), .. Line("0", 0, 1, 9, 1, (6, "DOT"), (48, 0.25)), .. Insert("BRACKET", 100, 50, "0", (70, 2), (44, 40.0)), (0, "LWPOLYLINE"), (8, "0"), (6, "GAS"), (90, 2), (70, 128), (10, 0.0), (20, 2.0), (10, 9.0), (20, 2.0),
            (0, "POLYLINE"), (8, "HIDDEN"), (70, 136), (66, 1), (0, "VERTEX"), (10, 0.0), (20, 5.0), (30, 0.0), (70, 32), (0, "VERTEX"), (10, 9.0), (20, 5.0), (30, 3.0), (70, 32), (0, "SEQEND")]).ToAscii());
        var text = new StringWriter(CultureInfo.InvariantCulture);
        DxfWriter.Write(EditedDrawing.SheetOf(drawing, []), text);

        var written = Read(Encoding.ASCII.GetBytes(text.ToString()));

        Assert.Equal(drawing.LinetypeScale, written.LinetypeScale);
        Assert.Equal(Styles(drawing), Styles(written));
        Assert.Equal(["", "", "BRACKET 100 50", "BRACKET 100 50 HOLE 110 50", "BRACKET 100 50 HOLE 110 50", "BRACKET 140 50", "BRACKET 140 50 HOLE 150 50", "BRACKET 140 50 HOLE 150 50", "", ""], Inserts(written));
        Assert.Equal(Inserts(drawing), Inserts(written));
        Assert.Equal(4, written.Inserts.Count);
        Assert.Equal([2.0, -1.0, 0.0, -1.0], written.Linetypes.Single(linetype => linetype.Name == "DOT").Elements);
    }

    /// <summary>Another default is written as its value: DXF has no variable for it.</summary>
    [Theory]
    [InlineData(null)]
    [InlineData(13)]
    public void A_written_drawing_keeps_lineweights_and_widths(int? defaultWeight)
    {
        var drawing = Read(LineweightDrawing.Of([.. LineweightDrawing.Line("0", 0), .. LineweightDrawing.Line("THICK", 1), .. LineweightDrawing.Line("0", 2, (370, 18)), .. LineweightDrawing.Line("THICK", 3, (370, -3)), .. LineweightDrawing.Insert("OUTER", "THICK"),
            .. LineweightDrawing.Polyline((43, 0.7), (10, 0.0), (20, 3.0), (10, 9.0), (20, 3.0)), (0, "TEXT"), (8, "0"), (370, 35), (10, 0.0), (20, 0.0), (40, 5.0), (1, "A")], 4, defaultWeight).ToAscii());
        var text = new StringWriter(CultureInfo.InvariantCulture);
        DxfWriter.Write(EditedDrawing.SheetOf(drawing, []), text);

        var written = Read(Encoding.ASCII.GetBytes(text.ToString()));

        Assert.Equal(8, written.Entities.Count);
        Assert.Equal(Enumerable.Range(0, 8).Select(drawing.LineWidthOf), Enumerable.Range(0, 8).Select(written.LineWidthOf));
        Assert.Equal(35, written.Texts[0].Lineweight);
    }

    private static Drawing Read(byte[] file) => DxfReader.Read(file, "test.dxf", DxfReadOptions.Default, CancellationToken.None);

    private static IEnumerable<(string, double, bool)> Styles(Drawing drawing) =>
        Enumerable.Range(0, drawing.Entities.Count).Select(entity => (drawing.Linetypes[drawing.LinetypeOf(entity)].Name, drawing.LineStyles[drawing.Entities[entity].LineStyle].Scale, drawing.LineStyles[drawing.Entities[entity].LineStyle].RunsThrough));

    private static IEnumerable<string> Inserts(Drawing drawing) => Enumerable.Range(0, drawing.Entities.Count).Select(entity => Named(drawing, drawing.Entities[entity].Insert));

    private static string Named(Drawing drawing, int number) => number == 0
        ? ""
        : (Named(drawing, drawing.Inserts[number - 1].Around) + FormattableString.Invariant($" {drawing.Blocks[drawing.BlockPaths[drawing.Inserts[number - 1].Path].Block]} {drawing.Inserts[number - 1].Position.X} {drawing.Inserts[number - 1].Position.Y}")).Trim();
}
