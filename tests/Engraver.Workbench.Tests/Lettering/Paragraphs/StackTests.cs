using Engraver.Core.Geometry;
using Engraver.Workbench.Lettering;
using static Engraver.Workbench.Tests.Lettering.Paragraphs.LaidParagraphs;

namespace Engraver.Workbench.Tests.Lettering.Paragraphs;

/// <summary>Fractions and tolerances: letters of the height that is valid before \S, which AutoCAD writes as \H0.7x.</summary>
public class StackTests
{
    [Fact]
    public void A_fraction_is_centred_over_its_bar()
    {
        var layout = Of(@"\S1/100;");
        var middle = Advance("100") / 2.0;
        Assert.Equal([(R(middle - (Advance("1") / 2.0)), 14.0), (0.0, 0.0), (R(Advance("1")), 0.0), (R(Advance("10")), 0.0)], Raised(layout));
        var bar = Assert.Single(layout.Rules);
        Assert.Equal((0.0, 12.0, R(Advance("100")), 12.0), Raised(layout, bar.From, bar.To));
    }

    [Fact]
    public void A_tolerance_has_no_bar_and_begins_at_the_left()
    {
        var layout = Of(@"\S+0.1^-0.25;");
        Assert.Empty(layout.Rules);
        Assert.Equal((0.0, 14.0), Raised(layout)[0]);
        Assert.Equal((0.0, 0.0), Raised(layout)[4]);
    }

    [Fact]
    public void A_diagonal_fraction_has_its_texts_on_both_sides_of_a_bar()
    {
        var layout = Of(@"\S1#2;");
        Assert.Equal([(0.0, 10.0), (R(Advance("1")), 0.0)], Raised(layout));
        var bar = Assert.Single(layout.Rules);
        Assert.Equal((R(Advance("1") - 5.0), 0.0, R(Advance("1") + 5.0), 20.0), Raised(layout, bar.From, bar.To));
    }

    [Theory]
    [InlineData("^2", 0.0)]
    [InlineData("2^", 14.0)]
    public void A_part_of_a_stack_keeps_its_place_when_the_other_is_empty(string stack, double height) => Assert.Equal(height, Of($@"H\S{stack};").Glyphs[1].Map.Origin.Y - Of($@"H\S{stack};").Glyphs[0].Map.Origin.Y, 9);

    [Theory]
    [InlineData(@"\A0;", 0.0)]
    [InlineData(@"\A1;", 5.0 - 8.4)]
    [InlineData(@"\A2;", 10.0 - 16.8)]
    public void A_stack_is_at_the_bottom_the_centre_or_the_top_of_the_line(string alignment, double lower)
    {
        var layout = Of(alignment + @"H{\H0.7x;\S1/2;}H");
        Assert.Equal(lower, layout.Glyphs[2].Map.Origin.Y - layout.Glyphs[0].Map.Origin.Y, 9);
        Assert.Equal(0.7 * layout.Glyphs[0].Map.YAxis.Y, layout.Glyphs[2].Map.YAxis.Y, 9);
        Assert.Equal(Advance("H") + (0.7 * Advance("2")), layout.Glyphs[3].Map.Origin.X, 9);
    }

    [Fact]
    public void A_high_stack_moves_its_line_down()
    {
        var layout = Of(@"H\PH\S1/2;");
        Assert.Equal(-10.0 - (20.0 / 3.0) - (14.0 + Box('1').Top), layout.Glyphs[1].Map.Origin.Y, 4);
    }

    private static double R(double value) => Math.Round(value, 9);

    /// <summary>Places above the lowest baseline, rounded.</summary>
    private static (double X, double Y)[] Raised(TextLayout layout)
    {
        var lowest = layout.Glyphs.Min(glyph => glyph.Map.Origin.Y);
        return [.. layout.Glyphs.Select(glyph => (R(glyph.Map.Origin.X), R(glyph.Map.Origin.Y - lowest)))];
    }

    private static (double, double, double, double) Raised(TextLayout layout, Point2D from, Point2D to)
    {
        var lowest = layout.Glyphs.Min(glyph => glyph.Map.Origin.Y);
        return (R(from.X), R(from.Y - lowest), R(to.X), R(to.Y - lowest));
    }
}
