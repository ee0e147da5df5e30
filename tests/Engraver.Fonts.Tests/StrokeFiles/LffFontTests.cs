using System.Text;
using Engraver.Fonts.StrokeFiles;

namespace Engraver.Fonts.Tests.StrokeFiles;

public class LffFontTests
{
    private const string Header = "# Format:            LibreCAD Font 1\n# Name:              Test Roman\n# LetterSpacing:     2\n# WordSpacing:       5.5\n# LineSpacingFactor: 1.2\n # A comment\n\n";

    [Fact]
    public void The_header_has_name_and_spacings()
    {
        var font = Font("[0041] A\n0,0;3,9;6,0\n1,3;5,3\n");

        Assert.Equal(("Test Roman", false, new FontMetrics(12, 9, 9, 3, 18), 0.0), (font.Name, font.IsOutline, font.Metrics, font.KerningOf('A', 'A')));
        Assert.Equal(8, font.GlyphOf('A')!.Advance);
        Assert.Equal(5.5, font.GlyphOf(' ')!.Advance);
        Assert.Equal(5.5, font.GlyphOf(0xA0)!.Advance);
        Assert.Equal([0x41], font.CodePoints);
    }

    [Fact]
    public void Without_a_header_the_spacings_are_those_of_LibreCAD()
    {
        var font = LffFont.Read("[0041] A\n0,0;3,9"u8.ToArray(), "file");

        Assert.Equal(("file", 15.0, 6.0, 6.75), (font.Name, font.Metrics.LineSpacing, font.GlyphOf('A')!.Advance, font.GlyphOf(' ')!.Advance));
    }

    [Theory]
    [InlineData("0,0;3,9;6,0\n1,3;5,3", "M0,0 L3,9 L6,0 M1,3 L5,3", 8)]
    [InlineData("0,0;4,0;4,3;0,0", "M0,0 L4,0 L4,3 L0,0 Z", 6)]
    [InlineData("0,0;4,0;4,0;0,0", "M0,0 L4,0 L0,0", 6)]
    [InlineData("1,0;1,7.5;2.5,9,A-0.414214;3,9\n0,6;3,6", "M1,0 L1,7.5 A2.5,9,-0.4142 L3,9 M0,6 L3,6", 5)]
    [InlineData("0,2;4,2,A1;0,2,A1", "M0,2 A4,2,1 A0,2,1 Z", 6)]
    [InlineData(" 0 , 0 ; 1. , .5 ; -2.5E-1,+1 , A 0.0", "M0,0 L1,0.5 L-0.25,1", 3)]
    [InlineData("1,1", "", 5.5)]
    [InlineData("1,1;", "", 5.5)]
    public void A_line_is_a_stroke_and_its_bulges_belong_to_the_vertices_where_arcs_end(string lines, string strokes, double advance)
    {
        var glyph = Font($"[0041] A\n{lines}\n").GlyphOf('A')!;

        Assert.Equal(strokes, StrokeText.Of(glyph));
        Assert.Equal(advance, glyph.Advance, 9);
    }

    [Fact]
    public void The_width_of_an_arc_is_that_of_its_curve() =>
        // A half circle from (0, 0) to (0, 4), with its centre at (0, 2), bulging to the right.
        Assert.Equal(4, Font("[0041] A\n0,0;0,4,A1\n").GlyphOf('A')!.Advance, 9);

    [Fact]
    public void A_copy_adds_the_lines_of_another_character()
    {
        var font = Font("[00C1] Á\nC0041\n2,9;4,10\n\n[0041] A\n0,0;3,9\n\n[1EA4]\nC00c1\n");

        Assert.Equal("M0,0 L3,9 M2,9 L4,10", StrokeText.Of(font.GlyphOf(0xC1)!));
        Assert.Equal("M0,0 L3,9 M2,9 L4,10", StrokeText.Of(font.GlyphOf(0x1EA4)!));
        Assert.Equal(6, font.GlyphOf(0xC1)!.Advance);
    }

    [Theory]
    [InlineData("[0041] A")]
    [InlineData("[#0041]")]
    [InlineData("[[0041] A")]
    [InlineData("[41]]")]
    public void A_head_may_be_written_in_these_ways(string head) => Assert.Equal([0x41], Font($"{head}\n0,0;1,1\n").CodePoints);

    [Theory]
    [InlineData("2205")]
    [InlineData("2300")]
    public void The_diameter_sign_may_have_either_code(string code)
    {
        var font = Font($"[{code}]\n0,0;1,1\n");

        Assert.All((int[])[0x2205, 0x2300], sign => Assert.Equal((true, "M0,0 L1,1"), (font.Contains(sign), StrokeText.Of(font.GlyphOf(sign)!))));
    }

    [Fact]
    public void The_first_of_two_characters_with_the_same_code_counts() =>
        Assert.Equal("M0,0 L1,1", StrokeText.Of(Font("[0041]\n0,0;1,1\n\n[0041]\nC0041\n").GlyphOf('A')!));

    [Fact]
    public void Lines_may_end_as_on_Windows_and_the_file_may_start_with_a_mark() =>
        Assert.Equal("M0,0 L1,1", StrokeText.Of(LffFont.Read((byte[])[0xEF, 0xBB, 0xBF, .. "# Name: X\r\n[0041] A\r\n0,0;1,1\r\n"u8], "file").GlyphOf('A')!));

    [Theory]
    [InlineData("0,0;1")]
    [InlineData("0,0;1,1,1,1")]
    [InlineData("0,0;1,1,0.5")]
    [InlineData("0,0;1,x")]
    [InlineData("0,0;1,1,Ax")]
    [InlineData("0,0;1,NaN")]
    [InlineData("0,0;1,1e300")]
    [InlineData("C0041")]
    [InlineData("C0043")]
    [InlineData("Cxyz")]
    [InlineData("some text")]
    public void An_invalid_line_breaks_the_character_and_not_the_font(string line)
    {
        var font = Font($"[0041] A\n0,0;1,1\n{line}\n\n[0042] B\n0,0;1,1\n");

        Assert.True(font.Contains('A'));
        Assert.Throws<BrokenFontException>(() => font.GlyphOf('A'));
        Assert.Equal("M0,0 L1,1", StrokeText.Of(font.GlyphOf('B')!));
    }

    [Fact]
    public void A_character_that_the_font_does_not_have_is_null()
    {
        var font = Font("[0041] A\n0,0;1,1\n");

        Assert.Equal((false, null), (font.Contains('B'), font.GlyphOf('B')));
    }

    [Theory]
    [InlineData("")]
    [InlineData("# Name: Nothing\n")]
    [InlineData("0,0;1,1\n[0041]\n")]
    [InlineData("[xyz]\n0,0;1,1\n")]
    [InlineData("[110000]\n0,0;1,1\n")]
    [InlineData("# LetterSpacing: wide\n[0041]\n0,0;1,1\n")]
    [InlineData("# WordSpacing: -1\n[0041]\n0,0;1,1\n")]
    [InlineData("# LineSpacingFactor: 1e9\n[0041]\n0,0;1,1\n")]
    public void A_file_that_is_not_a_font_is_refused(string text) => Assert.Throws<BrokenFontException>(() => LffFont.Read(Encoding.UTF8.GetBytes(text), "file"));

    private static LffFont Font(string glyphs) => LffFont.Read(Encoding.UTF8.GetBytes(Header + glyphs), "file");
}
