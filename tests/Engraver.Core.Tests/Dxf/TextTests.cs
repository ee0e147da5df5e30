using System.Text;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

public class TextTests
{
    [Theory]
    [InlineData("%%c12.5 %%p0.1", "\u230012.5 \u00B10.1")]
    [InlineData("90%%d %%D", "90\u00B0 \u00B0")]
    [InlineData("%%uunder%%u %%oover%%O", "under over")]
    [InlineData("100%%% %%065%%066", "100% AB")]
    [InlineData("50% %x %%", "50% %x %%")]
    [InlineData(@"\U+00D8 8 \M+5B0A1", "\u00D8 8 \u554A")]
    [InlineData("a^Ib^ c", "a\tb^c")]
    [InlineData(@"C:\path {x}", @"C:\path {x}")]
    public void A_text_says_what_its_codes_mean(string written, string read) =>
        Assert.Equal(read, Single((0, "TEXT"), (10, 0), (20, 0), (40, 1), (1, written)).Content);

    [Theory]
    [InlineData(@"one\Ptwo", "one\ntwo")]
    [InlineData(@"{\fArial|b1|i0|c0;bold} {\H2.5x;\C1;red}", "bold red")]
    [InlineData(@"\A1;M8\S+0.1^-0.2;", "M8+0.1/-0.2")]
    [InlineData(@"1\S1/2; 2\S3#4; x\S2^ ;", "11/2 23/4 x2")]
    [InlineData(@"\Lunder\l \Oover\o \Kout\k", "under over out")]
    [InlineData(@"a\~b \\ \{ \}", "a\u00A0b \\ { }")]
    [InlineData(@"\pxqc;centred \W0.8;narrow\T2;wide\Q15;lean", "centred narrowwidelean")]
    [InlineData(@"\Hopen and never closed", "open and never closed")]
    [InlineData(@"ends with \", @"ends with \")]
    [InlineData("%%c8", "\u23008")]
    public void An_mtext_leaves_its_formatting_out(string written, string read) =>
        Assert.Equal(read, Single((0, "MTEXT"), (10, 0), (20, 0), (40, 1), (1, written)).Content);

    [Fact]
    public void A_long_mtext_is_joined_in_file_order_and_stops_where_another_object_is_packed_in()
    {
        var text = Single((0, "MTEXT"), (10, 0), (20, 0), (40, 1), (3, "one "), (3, "two "), (1, "three"), (101, "Embedded Object"), (10, 9), (1, "not mine"));

        Assert.Equal(("one two three", 0.0), (text.Content, text.Position.X));
    }

    [Fact]
    public void A_text_keeps_place_size_style_and_alignment()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4)
            .Section("TABLES", (0, "TABLE"), (2, "STYLE"), (0, "STYLE"), (2, "Roman"), (3, "romans.shx"), (0, "ENDTAB"))
            .Section("ENTITIES", [(0, "TEXT"), (5, "2F"), (8, "Engrave"), (10, 1), (20, 2), (11, 30), (21, 40), (40, 2.5), (41, 0.8), (50, 15), (51, 10), (7, "ROMAN"), (72, 2), (73, 3), (1, "x")]).End());
        var text = Assert.Single(drawing.Texts);

        Assert.Equal((new Vector3D(30, 40, 0), 2.5, 0.8, 15.0, 10.0), (text.Position, text.Height, text.WidthFactor, text.Rotation.Degrees, text.Oblique.Degrees));
        Assert.Equal((TextColumnAlignment.Right, TextRowAlignment.Top, "romans.shx", "Engrave", 0x2FUL), (text.Column, text.Row, text.Font, drawing.Layers[text.Layer].Name, text.Handle));
    }

    [Fact]
    public void A_fitted_text_has_both_ends()
    {
        var text = Single((0, "TEXT"), (10, 1), (20, 2), (11, 9), (21, 2), (40, 1), (72, 5), (1, "x"));

        Assert.Equal((new Vector3D(1, 2, 0), new Vector3D(9, 2, 0), TextColumnAlignment.Fit), (text.Position, text.End, text.Column));
    }

    [Theory]
    [InlineData(1, TextColumnAlignment.Left, TextRowAlignment.Top)]
    [InlineData(5, TextColumnAlignment.Centre, TextRowAlignment.Middle)]
    [InlineData(9, TextColumnAlignment.Right, TextRowAlignment.Bottom)]
    public void The_attachment_of_an_mtext_is_its_alignment(int attachment, TextColumnAlignment column, TextRowAlignment row)
    {
        var text = Single((0, "MTEXT"), (10, 0), (20, 0), (40, 1), (71, attachment), (11, 0), (21, 1), (1, "x"));

        Assert.Equal((column, row, 90.0), (text.Column, text.Row, text.Rotation.Degrees));
    }

    [Fact]
    public void Texts_of_blocks_and_attributes_are_placed_with_their_insert()
    {
        (int, object)[] inside = [(0, "TEXT"), (8, "0"), (10, 1), (20, 0), (40, 2), (1, "in")];
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("BLOCKS", [(0, "BLOCK"), (2, "B"), .. inside, (0, "ENDBLK")])
            .Section("ENTITIES", (0, "INSERT"), (8, "L"), (2, "B"), (10, 10), (20, 0), (41, 3), (42, 3), (50, 90), (66, 1), (0, "ATTRIB"), (10, 7), (20, 8), (40, 1), (1, "value"), (2, "TAG"), (70, 1), (0, "SEQEND")).End());

        Assert.Equal(["in", "value"], drawing.Texts.OrderBy(text => text.Content.Length).Select(text => text.Content));
        var text = drawing.Texts.Single(placed => placed.Type == "TEXT");
        Assert.Equal((10.0, 3.0, 6.0, 90.0, "L"), (text.Position.X, text.Position.Y, text.Height, text.Rotation.Degrees, drawing.Layers[text.Layer].Name));
        Assert.True(drawing.Texts.Single(placed => placed.Type == "ATTRIB").Hidden);
        Assert.Equal(1, drawing.Balance.TextCounts["ATTRIB"]);
    }

    /// <summary>A constant attribute has no ATTRIB: every copy shows the text in the block.</summary>
    [Fact]
    public void A_constant_attribute_is_a_text_of_every_copy_and_any_other_definition_is_none()
    {
        (int, object)[] Definition(string value, int flags) => [(0, "ATTDEF"), (8, "0"), (10, 1), (20, 0), (40, 2), (1, value), (3, ""), (2, "TAG"), (70, flags)];
        (int, object)[] insert = [(0, "INSERT"), (8, "L"), (2, "B"), (10, 10), (20, 0)];
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("BLOCKS", [(0, "BLOCK"), (2, "B"), .. Definition("SERIAL-1", 2), .. Definition("hidden", 3), .. Definition("asked", 0), (0, "ENDBLK")])
            .Section("ENTITIES", [.. insert, .. insert, .. Definition("template", 2)]).End());

        Assert.Equal(["SERIAL-1", "SERIAL-1"], drawing.Texts.Where(text => !text.Hidden).Select(text => text.Content));
        Assert.Equal(["hidden", "hidden"], drawing.Texts.Where(text => text.Hidden).Select(text => text.Content));
        Assert.Equal(4, drawing.Balance.TextCounts["ATTDEF"]);
    }

    [Fact]
    public void A_mirrored_text_says_so()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("BLOCKS", (0, "BLOCK"), (2, "B"), (0, "TEXT"), (10, 1), (20, 0), (40, 2), (1, "in"), (0, "ENDBLK"))
            .Section("ENTITIES", (0, "INSERT"), (2, "B"), (10, 0), (20, 0), (41, -1), (0, "TEXT"), (10, 1), (20, 0), (40, 1), (1, "x"), (230, -1), (210, 0), (220, 0)).End());

        Assert.All(drawing.Texts, text => Assert.True(text.Mirrored));
        Assert.All(drawing.Texts, text => Assert.Equal(-1.0, text.Position.X));
    }

    [Fact]
    public void An_array_of_a_thousand_million_texts_is_counted_and_not_kept()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("BLOCKS", (0, "BLOCK"), (2, "B"), (0, "TEXT"), (10, 1), (20, 0), (40, 2), (1, "in"), (0, "ENDBLK"))
            .Section("ENTITIES", (0, "INSERT"), (2, "B"), (10, 0), (20, 0), (70, 32000), (71, 32000), (44, 1), (45, 1)).End());

        Assert.Equal((0, 1_024_000_000), (drawing.Texts.Count, drawing.Balance.TextCounts["TEXT"]));
        Assert.Contains("DXF0039", DxfReading.Ids(drawing));
    }

    [Fact]
    public void Text_is_read_in_the_code_page_of_the_file()
    {
        var bytes = CodePagesEncodingProvider.Instance.GetEncoding(1251)!.GetBytes(Encoding.UTF8.GetString(new DxfText()
            .Section("HEADER", (9, "$ACADVER"), (1, "AC1015"), (9, "$DWGCODEPAGE"), (3, "ANSI_1251")).Section("ENTITIES", (0, "TEXT"), (10, 0), (20, 0), (40, 1), (1, "Деталь №5")).End().ToAscii()));

        Assert.Equal("Деталь №5", Assert.Single(DxfReading.Of(bytes).Texts).Content);
    }

    /// <summary>Each code searches for its end only if there is one: a search to the end of the text for each of them would take minutes.</summary>
    [Fact]
    public void A_million_codes_that_never_end_are_left_out()
    {
        var codes = string.Concat(Enumerable.Repeat(@"\A\S", 1_000_000));

        Assert.Equal("x;y", Single((0, "MTEXT"), (10, 0), (20, 0), (40, 1), (1, "x;" + codes + "y")).Content);
    }

    private static PlacedText Single(params ReadOnlySpan<(int Code, object Value)> pairs) => Assert.Single(DxfReading.Entities(pairs).Texts);
}
