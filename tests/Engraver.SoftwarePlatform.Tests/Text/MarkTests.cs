using Avalonia;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Engraver.Fonts.OpenType;
using Engraver.SoftwarePlatform.Text;
using Engraver.TestKit;

namespace Engraver.SoftwarePlatform.Tests.Text;

public class MarkTests
{
    /// <summary>Glyph 1 is both letter and mark: its anchor as a letter is (250, 700), as a mark (300, 100).</summary>
    private static readonly SoftwareTypeface s_font = Font();

    [Fact]
    public void A_mark_is_moved_until_its_anchor_lies_on_the_letters()
    {
        Assert.Equal(new Vector(-50, 600), s_font.Marks.Find(1, 1));
        Assert.Null(s_font.Marks.Find(0, 1));
        Assert.Null(s_font.Marks.Find(1, 0));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void A_shaped_mark_stands_on_its_letter_in_both_directions(sbyte bidiLevel)
    {
        var options = new TextShaperOptions(s_font.GlyphTypeface, 1000, bidiLevel, null, 0, 0);
        var glyphs = new SoftwareTextShaper().ShapeText("A\u0301".AsMemory(), options);
        var mark = glyphs[1];

        Assert.Equal(600, glyphs[0].GlyphAdvance);
        Assert.Equal(0, mark.GlyphAdvance);
        Assert.Equal(-50 - 600, mark.GlyphOffset.X, 6);
        Assert.Equal(-600, mark.GlyphOffset.Y, 6);
    }

    private static SoftwareTypeface Font()
    {
        byte[] coverage = [.. U(1), .. U(1), .. U(1)];
        byte[] marks = [.. U(1), .. U(0), .. U(6), .. Anchor(300, 100)];
        byte[] letters = [.. U(1), .. U(4), .. Anchor(250, 700)];
        byte[] attachment = [.. U(1), .. U(12), .. U(12), .. U(1), .. U(18), .. U(18 + marks.Length), .. coverage, .. marks, .. letters];
        byte[] lookup = [.. U(4), .. U(0), .. U(1), .. U(8), .. attachment];
        byte[] features = [.. U(1), .. "mark"u8, .. U(8), .. U(0), .. U(1), .. U(0)];
        byte[] scripts = [.. U(1), .. "DFLT"u8, .. U(8), .. U(4), .. U(0), .. U(0), .. U(0xFFFF), .. U(1), .. U(0)];
        int featuresAt = 10 + scripts.Length, lookupsAt = featuresAt + features.Length;
        byte[] table = [.. U(1), .. U(0), .. U(10), .. U(featuresAt), .. U(lookupsAt), .. scripts, .. features, .. U(1), .. U(4), .. lookup];
        var file = FontBuilder.TrueType("Marked", 4, 'A', 0x301).With("GPOS", table).Build();
        return SoftwareTypeface.TryCreate(new MemoryFontSource(file), 0, FontSimulations.None)!;
    }

    private static byte[] Anchor(int x, int y) => [.. U(1), .. U(x), .. U(y)];

    private static byte[] U(int value) => FontBuilder.U16(value);
}
