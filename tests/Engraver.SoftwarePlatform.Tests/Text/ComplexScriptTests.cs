using Avalonia.Media.TextFormatting;
using Engraver.SoftwarePlatform.Text;

namespace Engraver.SoftwarePlatform.Tests.Text;

/// <summary>What HarfBuzz adds: joined and reordered letters, ligatures, stacked marks, mirrored brackets.</summary>
public class ComplexScriptTests
{
    private const double Size = 20;

    [FontFact(InstalledFont.Arabic)]
    public void Arabic_letters_join()
    {
        var word = Shape(InstalledFont.Arabic, "\u0628\u0628\u0628", bidiLevel: 1); // three times beh
        var isolated = Shape(InstalledFont.Arabic, "\u0628", bidiLevel: 1)[0].GlyphIndex;

        Assert.Equal([2, 1, 0], word.Select(glyph => glyph.GlyphCluster));
        Assert.Equal(3, word.Select(glyph => glyph.GlyphIndex).Distinct().Count());
        Assert.DoesNotContain(isolated, word.Select(glyph => glyph.GlyphIndex));
    }

    [FontFact(InstalledFont.Arabic)]
    public void Lam_and_alef_are_one_glyph_and_one_cluster()
    {
        var glyph = Assert.Single(Shape(InstalledFont.Arabic, "\u0644\u0627", bidiLevel: 1));

        Assert.Equal(0, glyph.GlyphCluster);
        Assert.True(glyph.GlyphAdvance > 0);
    }

    [FontFact(InstalledFont.Arabic)]
    public void A_letter_joins_one_outside_of_the_text_that_is_shaped()
    {
        const string word = "\u0628\u0628\u0628";
        var whole = Shape(InstalledFont.Arabic, word, bidiLevel: 1);

        Assert.Equal(whole[1].GlyphIndex, Assert.Single(Shape(InstalledFont.Arabic, word.AsMemory(1, 1), 1)).GlyphIndex);
    }

    [FontFact(InstalledFont.Devanagari)]
    public void The_short_i_of_Hindi_stands_before_its_letter()
    {
        var ka = Assert.Single(Shape(InstalledFont.Devanagari, "\u0915")).GlyphIndex;
        var syllable = Shape(InstalledFont.Devanagari, "\u0915\u093F");

        Assert.Equal(2, syllable.Count);
        Assert.Equal(ka, syllable[1].GlyphIndex);
        Assert.Equal([0, 0], syllable.Select(glyph => glyph.GlyphCluster));
    }

    [FontFact(InstalledFont.Devanagari)]
    public void Letters_of_Hindi_form_a_conjunct()
    {
        var conjunct = Shape(InstalledFont.Devanagari, "\u0915\u094D\u0937"); // ksha

        Assert.Single(conjunct);
        Assert.NotEqual(0, conjunct[0].GlyphIndex);
    }

    [FontFact(InstalledFont.Bengali, InstalledFont.Tamil)]
    public void A_vowel_of_Bengali_and_Tamil_surrounds_its_letter()
    {
        foreach (var (family, letter, vowel) in new[] { (InstalledFont.Bengali, "\u0995", "\u09CB"), (InstalledFont.Tamil, "\u0B95", "\u0BCA") })
        {
            var glyph = Assert.Single(Shape(family, letter)).GlyphIndex;
            var syllable = Shape(family, letter + vowel);

            Assert.Equal(3, syllable.Count);
            Assert.Equal(glyph, syllable[1].GlyphIndex);
            Assert.All(syllable, part => Assert.Equal(0, part.GlyphCluster));
        }
    }

    [FontFact(InstalledFont.Thai)]
    public void Marks_of_Thai_do_not_advance_and_a_tone_stands_over_a_vowel()
    {
        var low = Shape(InstalledFont.Thai, "\u0E1B\u0E48"); // tone alone
        var high = Shape(InstalledFont.Thai, "\u0E01\u0E35\u0E48"); // tone over a vowel

        Assert.Equal(3, high.Count);
        Assert.All(high.Skip(1), mark => Assert.Equal(0, mark.GlyphAdvance));
        Assert.True(low.Count == 2 && (high[2].GlyphOffset.Y < low[1].GlyphOffset.Y || high[2].GlyphIndex != low[1].GlyphIndex));
    }

    [FontFact(InstalledFont.Arabic)]
    public void Points_of_Hebrew_stand_at_their_letter()
    {
        var glyphs = Shape(InstalledFont.Arabic, "\u05D1\u05B8\u05D2", bidiLevel: 1); // bet with qamats, gimel

        Assert.Equal([2, 0, 0], glyphs.Select(glyph => glyph.GlyphCluster));
        Assert.Equal(0, glyphs[1].GlyphAdvance);
        Assert.NotEqual(0, glyphs[1].GlyphOffset.X);
    }

    [Fact]
    public void Brackets_are_mirrored_in_text_that_runs_to_the_left()
    {
        var seen = Inter.Shape("(>", bidiLevel: 1);

        Assert.Equal(Inter.Shape("<")[0].GlyphIndex, seen[0].GlyphIndex);
        Assert.Equal(Inter.Shape(")")[0].GlyphIndex, seen[1].GlyphIndex);
    }

    [Fact]
    public void Two_marks_over_one_letter_are_stacked()
    {
        var vietnamese = Inter.Shape("xe\u0323\u0302y");

        Assert.Equal([0, 1, 4], vietnamese.Select(glyph => glyph.GlyphCluster));
        Assert.Equal(Inter.Shape("\u1EC7")[0].GlyphIndex, vietnamese[1].GlyphIndex);
    }

    [FontFact(InstalledFont.Devanagari)]
    public void Letter_spacing_is_added_once_to_each_cluster()
    {
        const string text = "\u0915\u093F\u0915\u094D\u0937"; // two syllables
        double Width(double spacing) => Shape(InstalledFont.Devanagari, text.AsMemory(), 0, spacing).Sum(glyph => glyph.GlyphAdvance);

        Assert.Equal(Width(0) + 2 * 2.5, Width(2.5), 9);
    }

    [FontFact(InstalledFont.Arabic)]
    public void A_tab_and_a_line_end_keep_their_widths_between_words()
    {
        var glyphs = Shape(InstalledFont.Arabic, "\u0628\t\u0628\r\n", bidiLevel: 1);

        Assert.Equal([3, 3, 2, 1, 0], glyphs.Select(glyph => glyph.GlyphCluster));
        Assert.Equal(0, glyphs[0].GlyphAdvance + glyphs[1].GlyphAdvance);
        Assert.Equal(4 * Shape(InstalledFont.Arabic, " ")[0].GlyphAdvance, glyphs[3].GlyphAdvance, 9);
    }

    [Fact]
    public void A_text_is_divided_by_scripts_with_spaces_at_what_is_before_them()
    {
        const string text = "(ab \u0915\u093F, \u0628\t";

        Assert.False(ScriptRun.IsSimple(text));
        Assert.Equal([(0, 4, false), (4, 4, true), (8, 1, true), (9, 1, false)], ScriptRun.Divide(text, false).Select(run => (run.Start, run.Length, run.IsComplex)));
        Assert.Equal([(0, 2, true), (2, 1, false), (3, 1, true)], ScriptRun.Divide("))\n)", true).Select(run => (run.Start, run.Length, run.IsComplex)));
    }

    [Theory]
    [InlineData("Feed 12.5 mm/s, größer \u2713", true)]
    [InlineData("\u03B1\u03B2 \u0436 \u4E2D \u3042 \uD55C e\u0301", true)]
    [InlineData("e\u0323\u0302", false)]
    [InlineData("\u0E01", false)]
    [InlineData("\u1112\u1161\u11AB", false)]
    public void One_glyph_for_each_character_is_enough_for_most_scripts(string text, bool isSimple) => Assert.Equal(isSimple, ScriptRun.IsSimple(text));

    private static List<GlyphInfo> Shape(string family, string text, sbyte bidiLevel = 0) => Shape(family, text.AsMemory(), bidiLevel);

    private static List<GlyphInfo> Shape(string family, ReadOnlyMemory<char> text, sbyte bidiLevel, double letterSpacing = 0)
    {
        var options = new TextShaperOptions(InstalledFont.TryFind(family)!.GlyphTypeface, Size, bidiLevel, null, 0, letterSpacing);
        return [.. new SoftwareTextShaper().ShapeText(text, options)];
    }
}
