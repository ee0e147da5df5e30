using Avalonia.Media;
using Engraver.Fonts.OpenType;
using Engraver.SoftwarePlatform.Text;
using Engraver.TestKit;

namespace Engraver.SoftwarePlatform.Tests.Text;

public class KerningTests
{
    [Fact]
    public void Pairs_are_kerned_again_and_again()
    {
        var kerning = Kerning(Pairs(coverage: 12));

        Assert.Equal([-80, -80, 0, -80], new[] { 1, 1, 0, 1 }.Select(second => kerning.Between(1, second)));
    }

    [Fact]
    public void A_table_that_points_outside_of_itself_means_no_kerning()
    {
        Assert.Equal(0, Kerning(Pairs(coverage: 5000)).Between(1, 1));
        Assert.Equal(0, Open([.. U(1), .. U(0), .. U(0), .. U(9000), .. U(10)]).Between(1, 1));
    }

    /// <summary>Format 1, coverage: glyph 1; one pair (1, -80) with a placement before the advance.</summary>
    private static byte[] Pairs(int coverage) => [.. U(1), .. U(coverage), .. U(5), .. U(0), .. U(1), .. U(18), .. U(1), .. U(1), .. U(1), .. U(1), .. U(1), .. U(30), .. U(-80)];

    private static TypefaceKerning Kerning(byte[] subtable)
    {
        byte[] lookup = [.. U(2), .. U(0), .. U(1), .. U(8), .. subtable];
        byte[] features = [.. U(1), .. "kern"u8, .. U(8), .. U(0), .. U(1), .. U(0)];
        return Open([.. U(1), .. U(0), .. U(0), .. U(10), .. U(10 + features.Length), .. features, .. U(1), .. U(4), .. lookup]);
    }

    private static TypefaceKerning Open(byte[] layout) =>
        SoftwareTypeface.TryCreate(new MemoryFontSource(FontBuilder.TrueType("Kerned", 4, 'A').With("GPOS", layout).Build()), 0, FontSimulations.None)!.Kerning;

    private static byte[] U(int value) => FontBuilder.U16(value);
}
