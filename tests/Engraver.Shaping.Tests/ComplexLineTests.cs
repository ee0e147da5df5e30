using Engraver.Fonts.OpenType;
using Engraver.TestKit;

namespace Engraver.Shaping.Tests;

/// <summary>The order of characters as they are seen; upper case letters stand for Hebrew ones in the expected strings.</summary>
public class ComplexLineTests
{
    private const string Hebrew = "\u05D0\u05D1\u05D2";
    private const string Arabic = "\u0627\u0628\u062C";

    [Theory]
    [InlineData("abc", "abc")]
    [InlineData("ABC", "CBA")]
    [InlineData("abc ABC def", "abc CBA def")]
    [InlineData("ABC abc", "abc CBA")] // the first letter makes the line run from right to left
    [InlineData("ABC 123", "123 CBA")]
    [InlineData("abc ABC 123 x", "abc 123 CBA x")] // a number after Hebrew belongs to it
    [InlineData("ABC 1,5 A", "A 1,5 CBA")]
    [InlineData("ABC -5% A", "A 5%- CBA")] // a sign before a number is not part of it (W4)
    [InlineData("a (ABC) b", "a (CBA) b")]
    [InlineData("12 ABC", "CBA 12")] // numbers are not letters: the line runs from right to left
    [InlineData("", "")]
    public void Characters_are_seen_in_their_direction(string written, string seen)
    {
        var text = string.Concat(written.Select(letter => letter is >= 'A' and <= 'C' ? Hebrew[letter - 'A'] : letter));

        var clusters = ComplexLine.Shape(text, FaceOf(' ', '%', '(', ')', ',', '-', '1', '2', '3', '5', 'a', 'b', 'c', 'd', 'e', 'f', 'x', 0x05D0, 0x05D1, 0x05D2)).Select(glyph => glyph.Cluster);

        Assert.Equal(seen, string.Concat(clusters.Select(cluster => written[cluster])));
    }

    [Fact]
    public void A_number_after_Arabic_is_on_its_left()
    {
        var clusters = ComplexLine.Shape(Arabic + " 12", FaceOf(' ', '1', '2', 0x0627, 0x0628, 0x062C)).Select(glyph => glyph.Cluster);

        Assert.Equal([4, 5, 3, 2, 1, 0], clusters);
    }

    [Theory]
    [InlineData("M\u00FCller \u03A9 \u0416 \u4E2D", false)]
    [InlineData("x \u05D0", true)]
    [InlineData("\u0628", true)]
    [InlineData("\u0915\u094D\u0937", true)]
    [InlineData("\u0E17", true)]
    [InlineData("a\u200Db", false)]
    public void Only_scripts_with_rules_of_their_own_are_complex(string text, bool isComplex) => Assert.Equal(isComplex, ComplexLine.IsComplex(text));

    [Fact]
    public void A_character_that_the_font_does_not_have_has_glyph_0_at_its_place()
    {
        var glyphs = ComplexLine.Shape("\u05D0\u05D3", FaceOf(0x05D0, 0x05D1, 0x05D2));

        Assert.Equal([(0, 1), (1, 0)], glyphs.Select(glyph => (glyph.Glyph, glyph.Cluster)));
        Assert.All(glyphs, glyph => Assert.Equal(600.0, glyph.Advance));
    }

    private static ShapingFace FaceOf(params int[] characters)
    {
        var font = new OutlineFont(new MemoryFontSource(FontBuilder.TrueType("Test", 12, characters).Build()));
        return ShapingFace.TryCreate(font.TableOf, (int)font.Metrics.UnitsPerEm) ?? throw new InvalidOperationException("HarfBuzz");
    }
}
