using Avalonia.Media.TextFormatting;
using Engraver.SoftwarePlatform.Tests.Drawing;

namespace Engraver.SoftwarePlatform.Tests.Text;

public class ShapingTests
{
    [Fact]
    public void A_and_V_stand_nearer_than_A_and_H()
    {
        double Advance(string pair) => Inter.Shape(pair)[0].GlyphAdvance;

        Assert.Equal(Advance("AA"), Advance("A"), 9);
        Assert.InRange(Advance("AV"), Advance("A") * 0.8, Advance("A") - 0.5);
        Assert.InRange(Advance("To"), Advance("T") * 0.7, Advance("T") - 0.5);
    }

    [Fact]
    public void Kerning_grows_with_the_size()
    {
        double Kern(double size) => Inter.Shape("AV", size)[0].GlyphAdvance - Inter.Shape("A", size)[0].GlyphAdvance;

        Assert.True(Kern(16) < 0);
        Assert.Equal(4 * Kern(16), Kern(64), 9);
    }

    [Fact]
    public void Text_that_runs_to_the_left_has_its_last_glyph_first()
    {
        var right = Glyphs(Inter.Shape("abc"));
        var left = Glyphs(Inter.Shape("abc", bidiLevel: 1));

        Assert.Equal([0, 1, 2], right.Select(glyph => glyph.GlyphCluster));
        Assert.Equal([2, 1, 0], left.Select(glyph => glyph.GlyphCluster));
        Assert.Equal(right.Select(glyph => glyph.GlyphIndex).Reverse(), left.Select(glyph => glyph.GlyphIndex));
    }

    [Fact]
    public void Kerning_of_text_that_runs_to_the_left_is_that_of_the_glyphs_as_seen()
    {
        // Logical "VA" is seen as A V.
        var seen = Glyphs(Inter.Shape("VA", bidiLevel: 1));
        double width = seen.Sum(glyph => glyph.GlyphAdvance), expected = Glyphs(Inter.Shape("AV")).Sum(glyph => glyph.GlyphAdvance);

        Assert.Equal(expected, width, 9);
        Assert.Equal(Inter.Shape("AV")[0].GlyphAdvance, seen[0].GlyphAdvance, 9);
    }

    [Fact]
    public void Letter_spacing_is_added_to_every_letter()
    {
        double Width(double spacing) => Glyphs(Inter.Shape("abcd", letterSpacing: spacing)).Sum(glyph => glyph.GlyphAdvance);

        Assert.Equal(Width(0) + 4 * 2.5, Width(2.5), 9);
    }

    [Fact]
    public void Line_ends_and_invisible_characters_have_no_width_and_their_own_clusters()
    {
        var glyphs = Glyphs(Inter.Shape("a\r\nb\u200Bc"));

        Assert.Equal([0, 1, 1, 3, 4, 5], glyphs.Select(glyph => glyph.GlyphCluster));
        Assert.Equal(0, glyphs[1].GlyphAdvance + glyphs[2].GlyphAdvance + glyphs[4].GlyphAdvance);
        Assert.All(glyphs, glyph => Assert.NotEqual(0, glyph.GlyphIndex));
    }

    [Fact]
    public void A_tab_is_as_wide_as_asked()
    {
        Assert.Equal(48, Inter.Shape("\ta", tabWidth: 48)[0].GlyphAdvance);
        Assert.Equal(4 * Inter.Shape(" ")[0].GlyphAdvance, Inter.Shape("\t")[0].GlyphAdvance, 9);
    }

    [Fact]
    public void A_character_of_two_code_units_is_one_glyph()
    {
        var glyphs = Glyphs(Inter.Shape("a\U0001D11Eb"));

        Assert.Equal([0, 1, 3], glyphs.Select(glyph => glyph.GlyphCluster));
    }

    [Fact]
    public void A_combining_mark_stands_over_its_letter()
    {
        var glyphs = Glyphs(Inter.Shape("e\u0301x"));

        Assert.Equal([0, 0, 2], glyphs.Select(glyph => glyph.GlyphCluster));
        Assert.Equal(0, glyphs[1].GlyphAdvance);
        using var combined = new Picture(40, 40).Draw(c => c.DrawGlyphRun(Picture.Brush(Avalonia.Media.Colors.Black), Inter.Run("e\u0301", 32, 5, 32)));
        using var composed = new Picture(40, 40).Draw(c => c.DrawGlyphRun(Picture.Brush(Avalonia.Media.Colors.Black), Inter.Run("\u00E9", 32, 5, 32)));
        var (whole, parts) = (Box(composed), Box(combined));
        Assert.Equal((whole.Left, whole.Top, whole.Bottom), (parts.Left, parts.Top, parts.Bottom));
        Assert.InRange(parts.Right, whole.Right, whole.Right + 2);
    }

    private static (int Left, int Top, int Right, int Bottom) Box(Picture picture)
    {
        var inked = Enumerable.Range(0, 40 * 40).Where(i => picture.Alpha(i % 40, i / 40) > 100).ToList();
        return (inked.Min(i => i % 40), inked.Min(i => i / 40), inked.Max(i => i % 40), inked.Max(i => i / 40));
    }

    private static List<GlyphInfo> Glyphs(ShapedBuffer buffer) => [.. buffer];
}
