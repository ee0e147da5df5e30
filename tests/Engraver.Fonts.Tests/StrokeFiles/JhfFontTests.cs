using System.Text;
using Engraver.Fonts.StrokeFiles;

namespace Engraver.Fonts.Tests.StrokeFiles;

/// <summary>Letters are coordinates around R: Q is -1, S is 1, F is -12 and the top of a capital, [ is 9 and its foot.</summary>
public class JhfFontTests
{
    private const string Space = "12345  1JZ\n";

    [Fact]
    public void Pairs_are_edges_and_then_points_and_a_space_lifts_the_pen()
    {
        var font = Font(Space + "12345  9MWRFR[ RRYQZR[SZRY\n");

        Assert.Equal("M5,21 L5,0 M5,2 L4,1 L5,0 L6,1 L5,2 Z", StrokeText.Of(font.GlyphOf('!')!));
        Assert.Equal((10, 16, "file", false, 0.0), (font.GlyphOf('!')!.Advance, font.GlyphOf(' ')!.Advance, font.Name, font.IsOutline, font.KerningOf('A', 'V')));
        Assert.Equal(new FontMetrics(32, 21, 21, 7, 35), font.Metrics);
        Assert.Equal([0x20, 0x21], font.CodePoints);
    }

    [Fact]
    public void A_character_may_continue_on_the_next_lines()
    {
        var whole = Font(Space + " 2501  9I[RFJ[ RRFZ[ RMTWT\n" + "    1  3JZRRSS\n");
        var wrapped = Font("\n" + Space + " 2501  9I[RFJ[ R\r\nRFZ[\r\n RMTWT\r\n\r\n    1  3JZRRSS\n");

        Assert.Equal("M9,21 L1,0 M9,21 L17,0 M4,7 L14,7", StrokeText.Of(whole.GlyphOf('!')!));
        Assert.Equal(StrokeText.Of(whole.GlyphOf('!')!), StrokeText.Of(wrapped.GlyphOf('!')!));
        Assert.Equal("M8,9 L9,8", StrokeText.Of(wrapped.GlyphOf('"')!));
    }

    [Fact]
    public void A_character_that_the_font_does_not_have_is_null()
    {
        var font = Font(Space);

        foreach (var code in (int[])[0x1F, 0x21, -1]) Assert.Equal((false, null), (font.Contains(code), font.GlyphOf(code)));
    }

    [Theory]
    [InlineData("")]
    [InlineData("\n\n")]
    [InlineData("12345")]
    [InlineData("12345  0")]
    [InlineData("12345 -1JZ")]
    [InlineData("abcde  1JZ")]
    [InlineData("12345  xJZ")]
    [InlineData("12345  2JZ")]
    [InlineData("12345  1JZRR")]
    [InlineData("12345  2JZ\u00E4R")]
    [InlineData("12345  1J\t")]
    public void A_file_that_is_not_a_font_is_refused(string text) => Assert.Throws<BrokenFontException>(() => Font(text));

    [Fact]
    public void A_file_with_too_many_characters_is_refused() => Assert.Throws<BrokenFontException>(() => Font(string.Concat(Enumerable.Repeat(Space, 5000))));

    private static JhfFont Font(string text) => JhfFont.Read(Encoding.Latin1.GetBytes(text), "file");
}
