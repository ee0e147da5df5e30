using Engraver.Fonts.OpenType;
using Engraver.Fonts.OpenType.Layout;
using Engraver.TestKit;

namespace Engraver.Fonts.Tests.OpenType;

/// <summary>Pair tables written by hand.</summary>
public class KerningTests
{
    /// <summary>Format 1, coverage: glyph 1; one pair (1, -80) with a placement before the advance.</summary>
    private static readonly byte[] s_pairs = [.. U(1), .. U(12), .. U(5), .. U(0), .. U(1), .. U(18), .. U(1), .. U(1), .. U(1), .. U(1), .. U(1), .. U(30), .. U(-80)];

    /// <summary>Points outside of its table.</summary>
    private static readonly byte[] s_broken = [.. U(1), .. U(5000), .. U(4), .. U(0), .. U(1), .. U(18)];

    [Fact]
    public void Pairs_of_glyphs_have_their_value()
    {
        Assert.Equal(-80, Pairs(s_pairs, isExtension: false).Between(1, 1));
        Assert.Equal(0, Pairs(s_pairs, isExtension: false).Between(1, 0));
        Assert.Equal(0, Pairs(s_pairs, isExtension: false).Between(0, 1));
    }

    [Fact]
    public void Pairs_of_classes_have_their_value_also_behind_an_extension()
    {
        // Format 2: first classes {0, 1: glyph 1}, second classes {0, 1: glyphs 0 to 1}; the matrix is 0 0 / 0 -45.
        byte[] first = [.. U(1), .. U(1), .. U(1), .. U(1)];
        byte[] second = [.. U(2), .. U(1), .. U(0), .. U(1), .. U(1)];
        byte[] coverage = [.. U(2), .. U(1), .. U(0), .. U(1), .. U(0)];
        byte[] pairs = [.. U(2), .. U(24), .. U(4), .. U(0), .. U(24 + coverage.Length), .. U(24 + coverage.Length + first.Length), .. U(2), .. U(2), .. U(0), .. U(0), .. U(0), .. U(-45), .. coverage, .. first, .. second];

        Assert.Equal(-45, Pairs(pairs, isExtension: true).Between(1, 0));
        Assert.Equal(-45, Pairs(pairs, isExtension: false).Between(1, 1));
        Assert.Equal(0, Pairs(pairs, isExtension: true).Between(0, 0));
    }

    [Fact]
    public void A_table_that_points_outside_of_itself_is_broken() =>
        Assert.Throws<BrokenFontException>(() => Pairs(s_broken, isExtension: false).Between(1, 1));

    [Fact]
    public void Lists_of_the_older_table_are_added_or_replaced()
    {
        // Three lists for glyphs 1, 1: -30, then -20 more, then a vertical one that does not count.
        byte[] List(int coverage, int value) => [.. U(0), .. U(20), .. U(coverage), .. U(1), .. new byte[6], .. U(1), .. U(1), .. U(value)];
        byte[] added = [.. U(0), .. U(3), .. List(1, -30), .. List(1, -20), .. List(0, -99)];
        byte[] replaced = [.. U(0), .. U(2), .. List(1, -30), .. List(9, -20)];

        Assert.Equal(-50, Font().With("kern", added).Read().KerningOf('A', 'A'));
        Assert.Equal(-20, Font().With("kern", replaced).Read().KerningOf('A', 'A'));
        Assert.Equal(0, Font().With("kern", added).Read().KerningOf('A', 'B'));
    }

    [Fact]
    public void The_older_table_is_read_with_the_header_of_Apples_fonts()
    {
        byte[] list = [.. FontBuilder.U32(22), .. U(0), .. U(0), .. U(1), .. new byte[6], .. U(1), .. U(1), .. U(-70)];
        byte[] vertical = [.. FontBuilder.U32(22), .. U(0x8000), .. U(0), .. U(1), .. new byte[6], .. U(1), .. U(1), .. U(-9)];

        Assert.Equal(-70, Font().With("kern", [.. FontBuilder.U32(0x10000), .. FontBuilder.U32(2), .. vertical, .. list]).Read().KerningOf('A', 'A'));
    }

    [Fact]
    public void The_newer_table_decides_where_both_exist()
    {
        byte[] kern = [.. U(0), .. U(1), .. U(0), .. U(20), .. U(1), .. U(1), .. new byte[6], .. U(1), .. U(1), .. U(-30)];

        Assert.Equal(-80, Font().With("kern", kern).With("GPOS", Table(s_pairs, isExtension: false)).Read().KerningOf('A', 'A'));
    }

    private static FontBuilder Font() => FontBuilder.TrueType("Kerned", 4, 'A');

    private static PairKerning Pairs(byte[] subtable, bool isExtension) =>
        PairKerning.Read(new FontFile(new MemoryFontSource(Font().With("GPOS", Table(subtable, isExtension)).Build())));

    private static byte[] Table(byte[] subtable, bool isExtension)
    {
        byte[] body = isExtension ? [.. U(1), .. U(2), .. FontBuilder.U32(8), .. subtable] : subtable;
        byte[] lookup = [.. U(isExtension ? 9 : 2), .. U(0), .. U(1), .. U(8), .. body];
        byte[] features = [.. U(1), .. "kern"u8, .. U(8), .. U(0), .. U(1), .. U(0)];
        return [.. U(1), .. U(0), .. U(0), .. U(10), .. U(10 + features.Length), .. features, .. U(1), .. U(4), .. lookup];
    }

    private static byte[] U(int value) => FontBuilder.U16(value);
}
