using Engraver.Fonts.OpenType;
using Engraver.TestKit;

namespace Engraver.Fonts.Tests.OpenType;

public class CharacterMapTests
{
    [Theory]
    [InlineData(4)]
    [InlineData(6)]
    [InlineData(12)]
    public void Lists_of_three_formats_have_their_characters_and_no_others(int format)
    {
        var font = FontBuilder.TrueType("Square", format, 'A', 'C').Read();

        Assert.Equal([true, false, true], "ABC".Select(character => font.Contains(character)));
        Assert.False(font.Contains(0x10041));
        Assert.False(font.Contains(0xFFFF));
        Assert.False(font.Contains(-1));
        Assert.Null(font.GlyphOf('B'));
        Assert.Equal(600, font.GlyphOf('C')!.Advance);
    }

    [Fact]
    public void Characters_beyond_the_first_plane_are_found() => Assert.True(FontBuilder.TrueType("Far", 12, 'A', 0x1F600).Read().Contains(0x1F600));

    [Fact]
    public void Segments_may_refer_to_an_array_of_glyphs()
    {
        // Segment 65 to 67 with glyphs 2, none, 5 plus a delta of 1; then the last segment, with an invalid offset as in some fonts.
        byte[] map = [.. U(4), .. U(38), .. U(0), .. U(4), .. new byte[6], .. U(67), .. U(0xFFFF), .. U(0), .. U(65), .. U(0xFFFF), .. U(1), .. U(1), .. U(4), .. U(0xFFFF), .. U(2), .. U(0), .. U(5)];

        Assert.Equal([0, 3, 0, 6, 0], Glyphs(3, 1, map, 64, 65, 66, 67, 68));
        Assert.Equal([0], Glyphs(3, 1, map, 0xFFFF));
    }

    [Fact]
    public void Arrays_of_long_characters_and_groups_of_one_glyph_are_read()
    {
        byte[] array = [.. U(10), .. U(0), .. U32(24), .. U32(0), .. U32(0x20000), .. U32(2), .. U(7), .. U(8)];
        byte[] groups = [.. U(13), .. U(0), .. U32(28), .. U32(0), .. U32(1), .. U32(65), .. U32(90), .. U32(4)];

        Assert.Equal([0, 7, 8, 0], Glyphs(3, 10, array, 0x1FFFF, 0x20000, 0x20001, 0x20002));
        Assert.Equal([0, 4, 4, 0], Glyphs(3, 10, groups, 64, 65, 90, 91));
    }

    [Fact]
    public void A_symbol_font_has_its_characters_on_a_page_of_their_own()
    {
        byte[] map = [.. U(6), .. U(14), .. U(0), .. U(0xF041), .. U(2), .. U(1), .. U(2)];

        Assert.Equal([1, 2, 1, 0], Glyphs(3, 0, map, 0x41, 0x42, 0xF041, 0x43));
    }

    [Fact]
    public void Of_a_Macintosh_list_only_ASCII_is_used()
    {
        byte[] map = [.. U(0), .. U(262), .. U(0), .. Enumerable.Range(0, 256).Select(i => (byte)i)];

        Assert.Equal([65, 0], Glyphs(1, 0, map, 65, 0x8A));
    }

    [Fact]
    public void The_list_with_most_characters_is_used()
    {
        byte[] small = [.. U(6), .. U(12), .. U(0), .. U(65), .. U(1), .. U(1)];
        byte[] large = [.. U(12), .. U(0), .. U32(28), .. U32(0), .. U32(1), .. U32(65), .. U32(65), .. U32(2)];
        byte[] table = [.. U(0), .. U(3), .. U(0), .. U(5), .. U32(28), .. U(3), .. U(1), .. U32(28), .. U(3), .. U(10), .. U32(28 + small.Length), .. small, .. large];

        Assert.Equal(2, CharacterMap.ReadBest(new FontBytes(table)).GlyphOf(65));
    }

    [Fact]
    public void A_font_without_a_readable_list_is_broken() =>
        Assert.Throws<BrokenFontException>(() => CharacterMap.ReadBest(new FontBytes(Table(3, 1, [.. U(2), .. U(4)]))));

    private static IEnumerable<int> Glyphs(int platform, int encoding, byte[] map, params int[] characters)
    {
        var read = CharacterMap.ReadBest(new FontBytes(Table(platform, encoding, map)));
        return characters.Select(read.GlyphOf);
    }

    private static byte[] Table(int platform, int encoding, byte[] map) => [.. U(0), .. U(1), .. U(platform), .. U(encoding), .. U32(12), .. map];

    private static byte[] U(int value) => FontBuilder.U16(value);

    private static byte[] U32(long value) => FontBuilder.U32(value);
}
