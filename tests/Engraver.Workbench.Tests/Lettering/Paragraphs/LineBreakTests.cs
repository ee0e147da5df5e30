using Engraver.Core.Drawings;
using static Engraver.Workbench.Tests.Lettering.Paragraphs.LaidParagraphs;

namespace Engraver.Workbench.Tests.Lettering.Paragraphs;

/// <summary>Where lines end, and where their letters are. The sizes of boxes that AutoCAD wrote into drawings (groups 42 and 43 of the embedded object) show
/// its rules: blanks at the start of a text are kept, also when no word follows them in the line; a long word remains whole.</summary>
public class LineBreakTests
{
    private const int Decimals = 9;

    [Fact]
    public void A_line_ends_before_the_first_word_whose_letters_pass_the_width()
    {
        var fits = Inked("HO HO");
        Assert.Equal("HOHO|HO", Letters(Of("HO HO HO", Wrapped(fits))));
        Assert.Equal("HO|HO|HO", Letters(Of("HO HO HO", Wrapped(fits * 0.999))));
        Assert.Equal("HOHOHO", Letters(Of("HO HO HO", Wrapped(0.0))));
    }

    [Theory]
    [InlineData("HOHOHOHO HO", "HOHOHOHO|HO")]
    [InlineData("HO-HO HO-HO", "HO-HO|HO-HO")]
    [InlineData(@"HO\~HO HO", "HOHO|HO")]
    [InlineData(@"H{\H5;O}H HO", "HOH|HO")]
    [InlineData(@"HO \S1/2; HO", "HO|1|2|HO")]
    public void A_word_is_never_split(string raw, string lines) => Assert.Equal(lines, Letters(Of(raw, Wrapped(Inked("HO")))));

    [Fact]
    public void Blanks_at_the_end_of_a_line_do_not_count()
    {
        var rows = Rows(Of("HO     HO", Wrapped(Inked("HO") + 1.0) with { Attachment = 3 }));
        Assert.Equal(["HO", "HO"], rows.Select(row => row.Letters));
        Assert.All(rows, row => Assert.Equal(-Inked("HO"), row.X, Decimals));
    }

    [Fact]
    public void Blanks_at_the_start_of_a_text_are_kept_and_may_fill_a_line()
    {
        Assert.Equal(Advance(" "), Rows(Of(" HO"))[0].X, Decimals);
        var filled = Rows(Of(" HO", Wrapped(Inked("HO"))));
        Assert.Equal(0.0, filled[0].X, Decimals);
        Assert.Equal(-Height - (Height * 5.0 / 3.0), filled[0].Y, Decimals);
    }

    [Fact]
    public void Letters_follow_each_other_by_the_advances_of_the_font()
    {
        var layout = Of("AVE Tor");
        Assert.Equal([.. new[] { "", "A", "AV", "AVE ", "AVE T", "AVE To" }.Select(before => Math.Round(Advance(before), Decimals))], layout.Glyphs.Select(glyph => Math.Round(glyph.Map.Origin.X, Decimals)));
    }

    [Fact]
    public void Right_and_centred_lines_are_aligned_by_their_letters()
    {
        foreach (var width in (double[])[0.0, 100.0])
        {
            var right = Rows(Of(@"HO\PI", Wrapped(width) with { Attachment = 3 }));
            Assert.Equal([-Inked("HO"), -Inked("I")], right.Select(row => row.X), Near);
            var centred = Rows(Of(@"HO\PI", Wrapped(width) with { Attachment = 2 }));
            Assert.Equal([-(Inked("HO") + Box('H').Left) / 2.0, -(Inked("I") + Box('I').Left) / 2.0], centred.Select(row => row.X), Near);
        }
    }

    [Fact]
    public void A_paragraph_has_its_own_alignment_in_the_frame()
    {
        var rows = Rows(Of(@"\pqr;HO\P\pqc;HO\P\pql;HO\P\pq*;HO", Wrapped(100.0)));
        Assert.Equal([100.0 - Inked("HO"), 50.0 - ((Inked("HO") + Box('H').Left) / 2.0), 0.0, 0.0], rows.Select(row => row.X), Near);
        Assert.Equal(Inked("HOHO") - Inked("I"), Rows(Of(@"HOHO\P\pqr;I"))[1].X, Decimals);
    }

    [Fact]
    public void A_justified_line_fills_the_width_with_its_blanks_except_the_last()
    {
        var width = Inked("HO HO HO") + 6.0;
        var rows = Of(@"\pqj;HO HO HO HO HO", Wrapped(width)).Glyphs;
        Assert.Equal([0.0, Advance("HO ") + 3.0, Advance("HO HO ") + 6.0], new[] { 0, 2, 4 }.Select(i => rows[i].Map.Origin.X), Near);
        Assert.Equal([0.0, Advance("HO ")], new[] { 6, 8 }.Select(i => rows[i].Map.Origin.X), Near);
    }

    [Fact]
    public void A_distributed_line_fills_the_width_with_all_its_gaps()
    {
        var glyphs = Of(@"\pqd;HO I", Wrapped(Inked("HO I") + 6.0)).Glyphs;
        Assert.Equal([0.0, Advance("H") + 2.0, Advance("HO ") + 6.0], glyphs.Select(glyph => glyph.Map.Origin.X), Near);
    }

    [Fact]
    public void Indents_are_multiples_of_the_height()
    {
        var rows = Rows(Of(@"\pi-1,l2,r3;HO HO", Wrapped(20.0 + 30.0 + Inked("HO"))));
        Assert.Equal([10.0, 20.0], rows.Select(row => row.X), Near);
        Assert.Equal(100.0 - 30.0 - Inked("HO"), Rows(Of(@"\pr3,qr;HO", Wrapped(100.0)))[0].X, Decimals);
    }

    [Fact]
    public void A_tab_moves_to_the_next_multiple_of_four_heights()
    {
        var glyphs = Of("I^II^I^II").Glyphs;
        Assert.Equal([0.0, 40.0, 120.0], glyphs.Select(glyph => glyph.Map.Origin.X), Near);
    }

    [Fact]
    public void Stated_tabs_are_left_centred_or_right()
    {
        var glyphs = Of(@"\pt3,c8,r12;I^IHO^IHO^IHO^II").Glyphs;
        var centred = 80.0 - (Inked("HO") / 2.0);
        Assert.Equal([0.0, 30.0, centred, 120.0 - Inked("HO"), 160.0], new[] { 0, 1, 3, 5, 7 }.Select(i => glyphs[i].Map.Origin.X), Near);
    }

    [Fact]
    public void A_text_at_a_right_tab_does_not_move_before_the_text_to_its_left()
    {
        var glyphs = Of(@"\ptr5;HO^IHOHOHOHO").Glyphs;
        Assert.Equal(Advance("HO"), glyphs[2].Map.Origin.X, Decimals);
    }

    /// <summary>The words have different widths: the stroke font has boxes for their letters.</summary>
    [Fact]
    public void Words_from_right_to_left_are_in_the_order_in_which_they_are_seen()
    {
        var scale = Height / Font.Metrics.CapHeight;
        Assert.Equal([1.0, 4.0, 3.0, 2.0, 1.0], Of(@"H \W2;\U+05D0 \W3;\U+05D1 \W4;\U+05D2 \W1;H").Glyphs.Select(glyph => Math.Round(glyph.Map.XAxis.X / scale, 9)));
        Assert.Equal([4.0, 3.0, 2.0], Of(@"\W2;\U+05D0 \W3;\U+05D1 \W4;7").Glyphs.Select(glyph => Math.Round(glyph.Map.XAxis.X / scale, 9)));
        Assert.Equal([3.0, 2.0, 4.0], Of(@"\W2;\U+05D0 \W3;\U+05D1 \W4;\U+05D2", Wrapped(60.0)).Glyphs.Select(glyph => Math.Round(glyph.Map.XAxis.X / scale, 9)));
        var glyphs = Of(@"\U+05D0 \U+05D1 \U+05D2").Glyphs;
        Assert.Equal(glyphs.OrderBy(glyph => glyph.Map.Origin.X), glyphs);
    }

    private static WrittenParagraphs Wrapped(double width) => new() { ReferenceWidth = width };

    private static bool Near(double expected, double actual) => Math.Abs(expected - actual) < 1e-9;
}
