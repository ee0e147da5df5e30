using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Writing;
using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>What a drawing keeps of a text besides its summary: every value as written.</summary>
public class WrittenTextTests
{
    private static readonly (int, object)[] s_text =
    [
        (0, "TEXT"), (5, "2F"), (8, "0"), (62, 3), (10, 1), (20, 2), (30, 3), (11, 30), (21, 40), (31, 3), (40, 2.5), (41, 0.8), (50, 15), (51, 10), (7, "Roman"), (71, 6), (72, 5), (73, 2), (1, @"%%c\U+00D8 ^ x"),
        (210, 0), (220, 0), (230, -1),
    ];

    private static readonly (int, object)[] s_columns =
    [
        (1001, "ACAD"), (1000, "ACAD_MTEXT_COLUMN_INFO_BEGIN"), (1070, 75), (1070, 2), (1070, 79), (1070, 0), (1070, 76), (1070, 3), (1070, 78), (1070, 1), (1070, 48), (1040, 50.0), (1070, 49), (1040, 12.5),
        (1070, 50), (1070, 3), (1040, 20.0), (1040, 10.0), (1040, 0.0), (1000, "ACAD_MTEXT_COLUMN_INFO_END"), (1000, "ACAD_MTEXT_COLUMNS_BEGIN"), (1070, 47), (1070, 3), (1005, "1B4"), (1005, "1B5"), (1000, "ACAD_MTEXT_COLUMNS_END"),
        (1000, "ACAD_MTEXT_DEFINED_HEIGHT_BEGIN"), (1070, 46), (1040, 31.0), (1000, "ACAD_MTEXT_DEFINED_HEIGHT_END"),
    ];

    [Fact]
    public void A_text_is_kept_as_written()
    {
        var text = Assert.Single(DxfReading.Entities(s_text).Texts);
        var written = text.Written;

        Assert.Equal((@"%%c\U+00D8 ^ x", new Vector3D(1, 2, 3), new Vector3D(30, 40, 3), new Vector3D(0, 0, -1)), (written.Raw, written.Insertion, written.Second, written.Extrusion));
        Assert.Equal((2.5, 0.8, 15.0, 10.0), (written.Height, written.WidthFactor, written.Rotation.Degrees, written.Oblique.Degrees));
        Assert.Equal((TextGeneration.Backwards | TextGeneration.UpsideDown, 5, 2, null), (written.Generation, written.Horizontal, written.Vertical, written.Paragraphs));
        Assert.Equal((new Vector3D(-1, 2, -3), true, 3), (written.OwnSystem.Apply(written.Insertion), text.Inserts.IsIdentity, text.Colour.Index));
        Assert.Equal("\u2300\u00D8 ^x", text.Content);
    }

    [Fact]
    public void An_attribute_has_its_tag_and_a_definition_its_prompt()
    {
        (int, object)[] values = [(10, 1), (20, 0), (40, 2), (1, "v"), (2, "SERIAL"), (70, 2), (73, 7), (74, 3)];
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("BLOCKS", [(0, "BLOCK"), (2, "B"), (0, "ATTDEF"), (3, "Number?"), .. values, (0, "ENDBLK")])
            .Section("ENTITIES", [(0, "INSERT"), (2, "B"), (10, 0), (20, 0), (66, 1), (0, "ATTRIB"), .. values, (0, "SEQEND")]).End());

        Assert.Equal([("ATTDEF", "SERIAL", "Number?", 7, 3, 2), ("ATTRIB", "SERIAL", "", 7, 3, 2)],
            drawing.Texts.Select(text => (text.Type, text.Written.Tag, text.Written.Prompt, text.Written.FieldLength, text.Written.Vertical, text.Written.AttributeFlags)).Order());
    }

    /// <summary>A text in a block that is scaled differently in x and y is sheared when it is rotated: only a map states that.</summary>
    [Fact]
    public void The_inserts_around_a_text_are_a_map()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4)
            .Section("BLOCKS", (0, "BLOCK"), (2, "IN"), (10, 1), (20, 0), (0, "TEXT"), (62, 0), (10, 1), (20, 2), (40, 2), (50, 30), (1, "in"), (0, "ENDBLK"), (0, "BLOCK"), (2, "OUT"), (0, "INSERT"), (2, "IN"), (62, 0), (10, 5), (20, 0), (50, 90), (0, "ENDBLK"))
            .Section("ENTITIES", (0, "INSERT"), (2, "OUT"), (62, 4), (10, 100), (20, 0), (41, -2), (42, 3), (0, "INSERT"), (2, "OUT"), (10, 0), (20, 0)).End());
        var (first, second) = (drawing.Texts[0], drawing.Texts[1]);

        Assert.Same(first.Written, second.Written);
        Assert.Equal((4, DrawingColour.ByLayer), (first.Colour.Index, second.Colour));
        Assert.Equal((new Vector3D(1, 2, 0), 2.0, 30.0), (first.Written.Insertion, first.Written.Height, first.Written.Rotation.Degrees));
        Assert.Equal((new Vector3D(94, 0, 0), new Vector3D(94, 0, 0)), (first.Inserts.Apply(first.Written.Insertion), first.Position));
        Assert.Equal((new Vector3D(0, 3, 0), new Vector3D(2, 0, 0)), (first.Inserts.XAxis, first.Inserts.YAxis));
    }

    [Fact]
    public void A_paragraph_text_is_kept_as_written()
    {
        var written = Assert.Single(DxfReading.Entities((0, "MTEXT"), (10, 1), (20, 2), (30, 3), (40, 2.5), (41, 60), (71, 5), (72, 3), (3, @"{\H2;a\U+00"), (3, @"D8}"), (1, "end"), (7, "Roman"), (73, 2), (44, 1.5), (11, 0), (21, 1), (31, 0)).Texts).Written;

        Assert.Equal((@"{\H2;a\U+00D8}end", new Vector3D(1, 2, 3), 2.5), (written.Raw, written.Insertion, written.Height));
        Assert.Equal(new WrittenParagraphs { Attachment = 5, FlowDirection = 3, ReferenceWidth = 60, LineSpacingStyle = 2, LineSpacingFactor = 1.5, XAxis = new Vector3D(0, 1, 0) }, written.Paragraphs);
    }

    [Fact]
    public void Columns_come_from_the_extended_data()
    {
        var paragraphs = Assert.Single(DxfReading.Entities([(0, "MTEXT"), (10, 0), (20, 0), (40, 1), (50, 30), (1, "x"), .. s_columns]).Texts).Written.Paragraphs!;

        Assert.Equal((31.0, new TextColumns { Type = 2, Count = 3, IsFlowReversed = true, Width = 50, Gutter = 12.5, Heights = [20, 10, 0], LinkedHandles = [0x1B4, 0x1B5] }), (paragraphs.DefinedHeight, paragraphs.Columns));
    }

    [Fact]
    public void Columns_come_from_the_embedded_object()
    {
        var text = Assert.Single(DxfReading.Entities((0, "MTEXT"), (10, 0), (20, 0), (40, 1), (50, 30), (1, "x"), (101, "Embedded Object"), (70, 1), (10, 1), (20, 0), (30, 0), (11, 9), (21, 9), (31, 0), (40, 50), (41, 31), (42, 80), (43, 20), (71, 2), (72, 2), (44, 50), (45, 12.5), (73, 1), (74, 0), (46, 20), (46, 0)).Texts);

        Assert.Equal((31.0, new TextColumns { Type = 2, Count = 2, IsAutoHeight = true, Width = 50, Gutter = 12.5, Heights = [20, 0] }), (text.Written.Paragraphs!.DefinedHeight, text.Written.Paragraphs.Columns));
        Assert.Equal((new Vector3D(0, 0, 0), 30.0), (text.Position, text.Rotation.Degrees));
    }

    [Fact]
    public void Columns_come_from_groups_whose_heights_are_not_a_rotation()
    {
        var text = Assert.Single(DxfReading.Entities((0, "MTEXT"), (10, 0), (20, 0), (40, 1), (50, 30), (1, "x"), (75, 1), (76, 2), (78, 0), (79, 1), (48, 50), (49, 5), (50, 20), (50, 10)).Texts);

        Assert.Equal((30.0, new TextColumns { Type = 1, Count = 2, IsAutoHeight = true, Width = 50, Gutter = 5, Heights = [20, 10] }), (text.Rotation.Degrees, text.Written.Paragraphs!.Columns));
    }

    [Fact]
    public void Styles_are_kept_with_the_family_of_their_font()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("TABLES", (0, "TABLE"), (2, "STYLE"),
            (0, "STYLE"), (2, "Roman"), (70, 4), (40, 3.5), (41, 0.9), (50, 12), (71, 2), (3, "romans.shx"), (4, "bigfont.shx"),
            (0, "STYLE"), (2, "Title"), (3, "arial.ttf"), (1001, "OTHER"), (1000, "no"), (1001, "ACAD"), (1000, "Arial"), (1071, 50331682),
            (0, "STYLE"), (2, ""), (70, 1), (3, "shapes.shx"), (0, "STYLE"), (2, "ROMAN"), (3, "later.shx"), (0, "ENDTAB")).Section("ENTITIES").End());

        Assert.Equal([new TextStyle("Roman") { FontFile = "romans.shx", BigFontFile = "bigfont.shx", FixedHeight = 3.5, WidthFactor = 0.9, Oblique = Angle.FromDegrees(12), Generation = TextGeneration.Backwards, IsVertical = true },
            new TextStyle("Title") { FontFile = "arial.ttf", Family = "Arial", FamilyFlags = 50331682 }], drawing.Styles);
        Assert.Equal((true, true), (drawing.Styles[1].IsBold, drawing.Styles[1].IsItalic));
    }

    [Fact]
    public void Texts_and_styles_are_written_as_they_were_read()
    {
        (int, object)[] paragraph = [(0, "MTEXT"), (8, "0"), (10, 1), (20, 2), (40, 2.5), (41, 60), (71, 5), (72, 3), (3, new string('a', 249)), (1, @"{\H2;b} \S1^ 2; %%c"), (7, "Title"), (73, 2), (44, 1.5), (50, 20), .. s_columns];
        var before = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("TABLES", (0, "TABLE"), (2, "STYLE"),
            (0, "STYLE"), (2, "Roman"), (70, 4), (40, 3.5), (41, 0.9), (50, 12), (71, 2), (3, "romans.shx"), (4, "bigfont.shx"), (0, "STYLE"), (2, "Title"), (3, ""), (1001, "ACAD"), (1000, "Arial"), (1071, 34), (0, "ENDTAB"))
            .Section("ENTITIES", [.. s_text, .. paragraph]).End());
        using var output = new StringWriter();
        DxfWriter.Write(new DxfSheet([], []) { Texts = [.. before.Texts.Select(text => new DxfSheetText(text, "0"))], TextStyles = before.Styles }, output);
        var after = DxfReading.Of(output.ToString());

        Assert.Equal(before.Texts.Select(text => text.Written with { Paragraphs = Unlinked(text) }), after.Texts.Select(text => text.Written));
        Assert.Equal(before.Texts.Select(text => (text.Content, text.Style, text.Font, text.Colour)), after.Texts.Select(text => (text.Content, text.Style, text.Font, text.Colour)));
        Assert.Equal(before.Styles, after.Styles.Where(style => style.Name != "Standard"));
    }

    private static WrittenParagraphs? Unlinked(PlacedText text) =>
        text.Written.Paragraphs is { Columns: { } columns } paragraphs ? paragraphs with { Columns = columns with { LinkedHandles = [] } } : text.Written.Paragraphs;
}
