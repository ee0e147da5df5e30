using Avalonia.Media;
using Engraver.SoftwarePlatform.Text;

namespace Engraver.SoftwarePlatform.Tests.Text;

/// <summary>Pair tables written by hand, for what Inter does not use.</summary>
public class KerningTests
{
    [Fact]
    public void Pairs_of_glyphs_have_their_value()
    {
        // Format 1, coverage: glyph 1; one pair (1, -80) with a placement before the advance.
        byte[] pairs = [.. U(1), .. U(12), .. U(5), .. U(0), .. U(1), .. U(18), .. U(1), .. U(1), .. U(1), .. U(1), .. U(1), .. U(30), .. U(-80)];

        Assert.Equal(-80, Kerning(pairs, isExtension: false).Between(1, 1));
        Assert.Equal(0, Kerning(pairs, isExtension: false).Between(1, 0));
        Assert.Equal(0, Kerning(pairs, isExtension: false).Between(0, 1));
    }

    [Fact]
    public void Pairs_of_classes_have_their_value_also_behind_an_extension()
    {
        // Format 2: first classes {0, 1: glyph 1}, second classes {0, 1: glyphs 0 to 1}; the matrix is 0 0 / 0 -45.
        byte[] first = [.. U(1), .. U(1), .. U(1), .. U(1)];
        byte[] second = [.. U(2), .. U(1), .. U(0), .. U(1), .. U(1)];
        byte[] coverage = [.. U(2), .. U(1), .. U(0), .. U(1), .. U(0)];
        byte[] pairs = [.. U(2), .. U(24), .. U(4), .. U(0), .. U(24 + coverage.Length), .. U(24 + coverage.Length + first.Length), .. U(2), .. U(2), .. U(0), .. U(0), .. U(0), .. U(-45), .. coverage, .. first, .. second];

        Assert.Equal(-45, Kerning(pairs, isExtension: true).Between(1, 0));
        Assert.Equal(-45, Kerning(pairs, isExtension: false).Between(1, 1));
        Assert.Equal(0, Kerning(pairs, isExtension: true).Between(0, 0));
    }

    [Fact]
    public void A_table_that_points_outside_of_itself_means_no_kerning()
    {
        byte[] pairs = [.. U(1), .. U(5000), .. U(4), .. U(0), .. U(1), .. U(18)];

        Assert.Equal(0, Kerning(pairs, isExtension: false).Between(1, 1));
    }

    private static PairKerning Kerning(byte[] subtable, bool isExtension)
    {
        byte[] body = isExtension ? [.. U(1), .. U(2), .. FontBuilder.U32(8), .. subtable] : subtable;
        byte[] lookup = [.. U(isExtension ? 9 : 2), .. U(0), .. U(1), .. U(8), .. body];
        byte[] features = [.. U(1), .. "kern"u8, .. U(8), .. U(0), .. U(1), .. U(0)];
        byte[] table = [.. U(1), .. U(0), .. U(0), .. U(10), .. U(10 + features.Length), .. features, .. U(1), .. U(4), .. lookup];
        var font = FontBuilder.TrueType("Kerned", 4, 'A').With("GPOS", table).Build();
        return SoftwareTypeface.TryCreate(new MemoryFontSource(font), 0, FontSimulations.None)!.Kerning;
    }

    private static byte[] U(int value) => FontBuilder.U16(value);
}
