using Engraver.Core.Drawings;
using static Engraver.Workbench.Tests.Lettering.Paragraphs.LaidParagraphs;

namespace Engraver.Workbench.Tests.Lettering.Paragraphs;

/// <summary>The heights of lines and of the box around them.</summary>
public class LineSpacingTests
{
    private const double Standard = Height * 5.0 / 3.0;

    [Theory]
    [InlineData(1.0)]
    [InlineData(0.25)]
    [InlineData(1.5)]
    [InlineData(4.0)]
    public void Baselines_are_five_thirds_of_the_height_apart_by_the_factor(double factor)
    {
        foreach (var style in (int[])[0, 1, 2])
        {
            Assert.Equal([-Height, -Height - (Standard * factor), -Height - (2.0 * Standard * factor)], Baselines(@"H\PH\PH", new() { LineSpacingFactor = factor, LineSpacingStyle = style }), Near);
        }
    }

    [Fact]
    public void An_empty_paragraph_is_a_line_of_the_height_that_is_valid_there()
    {
        Assert.Equal(-Height - (2.0 * Standard), Baselines(@"H\P\PH")[^1], 9);
        var high = Baselines(@"H\P\H20;\P\H10;H")[^1];
        Assert.Equal(-10.0 - ((20.0 / 3.0) + 20.0) - ((40.0 / 3.0) + 10.0), high, 9);
    }

    [Fact]
    public void High_letters_move_their_line_down_and_leave_more_space_below()
    {
        var atLeast = Baselines(@"H\P\H2x;H\P\H0.5x;H");
        Assert.Equal([-10.0, -10.0 - (20.0 / 3.0) - 20.0, -10.0 - (20.0 / 3.0) - 20.0 - (40.0 / 3.0) - 10.0], atLeast, Near);
        var exactly = Baselines(@"H\P\H2x;H\P\H0.5x;H", new() { LineSpacingStyle = 2 });
        Assert.Equal([-10.0, -10.0 - Standard, -10.0 - (2.0 * Standard)], exactly, Near);
    }

    /// <summary>AutoCAD writes 2.71851 heights for two lines of Arial whose letters pass the capitals by 0.01705 above and below: 1 + 5/3 and
    /// three times 0.0173.</summary>
    [Fact]
    public void A_letter_above_the_capitals_moves_its_line_down()
    {
        var above = Box('\u00C5').Top - Height;
        Assert.True(above > 1.0);
        Assert.Equal([-Height - above, -Height - above - Standard - above], Baselines("\u00C5\\P\u00C5"), Near);
    }

    [Theory]
    [InlineData(@"H\P\psm2;H", 2.0 * Standard)]
    [InlineData(@"H\P\pse3;H", 30.0)]
    [InlineData(@"H\P\psa3;H", 30.0)]
    [InlineData(@"H\P\psm2;\ps*;H", Standard)]
    [InlineData(@"\pa1;H\P\pa0,b0.5;H", Standard + 15.0)]
    [InlineData(@"\pb1;H\XH", Standard)]
    public void A_paragraph_has_its_own_distances(string raw, double distance)
    {
        var lines = Baselines(raw);
        Assert.Equal(-Height, lines[0], 9);
        Assert.Equal(distance, lines[0] - lines[1], 9);
    }

    [Fact]
    public void The_box_of_the_letters_is_attached_at_all_nine_places()
    {
        for (var place = 1; place <= 9; place++)
        {
            var box = Box(Of(@"Hp\PHHHp", new() { Attachment = place }));
            var column = (place - 1) % 3;
            Assert.Equal(0.0, column switch { 0 => box.Left - Box('H').Left, 1 => box.Left + box.Right, _ => box.Right }, 4);
            Assert.Equal(0.0, ((place - 1) / 3) switch { 0 => box.Top, 1 => box.Top + box.Bottom, _ => box.Bottom }, 4);
        }
    }

    /// <summary>With a distance that is exact, AutoCAD writes 3 heights for two lines of which the second has a lower descender: 1 + 5/3 + 1/3.</summary>
    [Fact]
    public void An_exact_distance_has_a_box_that_does_not_depend_on_the_letters()
    {
        foreach (var raw in (string[])[@"H\PH", @"H\Pp", @"H\P\H0.5x;H"]) Assert.Equal(Height / 3.0, Baselines(raw, new() { LineSpacingStyle = 2, Attachment = 7 })[^1], 9);
    }

    /// <summary>Multiples of the height that AutoCAD wrote for texts of simplex.shx (embedded object, group 43): lines, blanks and empty paragraphs.</summary>
    [Theory]
    [InlineData("x", 0.0, 1.0)]
    [InlineData("Xxp^Jabc", 0.0, 2.66667)]
    [InlineData(@"a\Pab\PXpc\Pabcdef", 125.0, 6.0)]
    [InlineData(" abc     def            b", 36.01617, 4.33333)]
    [InlineData(@" abc\Pabcd", 8.347565, 4.33333)]
    [InlineData("                       spc                       def", 37.50425, 4.33333)]
    [InlineData(@"\Pabc  \Pabcabcabc\Pa\P\Pb", 36.01617, 9.33333)]
    public void Boxes_have_the_heights_that_AutoCAD_wrote(string raw, double width, double heights)
    {
        var layout = Of(raw, new() { ReferenceWidth = width, Attachment = 7 });
        var top = Of(raw, new() { ReferenceWidth = width }).Glyphs[0].Map.Origin.Y;
        Assert.Equal(heights * Height, layout.Glyphs[0].Map.Origin.Y - top, 4);
    }

    [Fact]
    public void Lower_letters_are_at_the_bottom_the_centre_or_the_top_of_the_line()
    {
        Assert.Equal([-10.0, -10.0, -7.5, -5.0], Of(@"H{\A0;\H5;H}{\A1;\H5;H}{\A2;\H5;H}").Glyphs.Select(glyph => glyph.Map.Origin.Y), Near);
    }

    private static double[] Baselines(string raw, WrittenParagraphs? written = null) => [.. Of(raw, written).Glyphs.Select(glyph => glyph.Map.Origin.Y)];

    private static bool Near(double expected, double actual) => Math.Abs(expected - actual) < 1e-9;
}
