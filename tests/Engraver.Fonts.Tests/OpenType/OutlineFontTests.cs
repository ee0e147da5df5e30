using System.Buffers.Binary;
using Engraver.Fonts.OpenType;
using Engraver.TestKit;

namespace Engraver.Fonts.Tests.OpenType;

public class OutlineFontTests
{
    [Fact]
    public void Each_face_of_a_collection_is_a_font()
    {
        var source = new MemoryFontSource(FontBuilder.Collection(FontBuilder.TrueType("First", 4, 'A'), FontBuilder.Cff("Second", [139, 139, 21, 209, 209, 69, 6, 14], characters: 'B')));

        Assert.Equal(2, FontFile.CountFaces(source));
        Assert.Equal(["First", "Second"], Enumerable.Range(0, 2).Select(face => new OutlineFont(source, face).Name));
        Assert.Equal((0.0, 0.0, 70.0, 70.0), GlyphShape.ControlBox(new OutlineFont(source, 1).GlyphOf('B')!));
        Assert.Throws<BrokenFontException>(() => new OutlineFont(source, 2));
        Assert.Throws<BrokenFontException>(() => new OutlineFont(source, -1));
    }

    [Fact]
    public void Without_a_cap_height_it_is_that_of_H_or_the_ascent()
    {
        Assert.Equal(new FontMetrics(1000, 800, 800, 200, 1000), FontBuilder.TrueType("Plain", 4, 'A').Read().Metrics);
        Assert.Equal(400, FontBuilder.TrueType("Plain", 4, 'A', 'H').Read().Metrics.CapHeight);
        Assert.Equal(700, FontBuilder.TrueType("Plain", 4, 'A', 'H').With("OS/2", Style(capHeight: 700)).Read().Metrics.CapHeight);
    }

    [Fact]
    public void Typographic_heights_are_used_where_the_font_prefers_them()
    {
        var hhea = new byte[36];
        foreach (var (offset, value) in ((int, int)[])[(4, 900), (6, -250), (8, 90), (34, 1)]) BinaryPrimitives.WriteInt16BigEndian(hhea.AsSpan(offset), (short)value);
        var font = FontBuilder.TrueType("Plain", 4, 'A').With("hhea", hhea);

        Assert.Equal((900.0, 250.0, 1240.0), Heights(font.With("OS/2", Style())));
        Assert.Equal((700.0, 300.0, 1050.0), Heights(font.With("OS/2", Style(selection: 1 << 7))));
        Assert.Equal((900.0, 250.0, 1240.0), Heights(font.Without("OS/2")));
    }

    [Fact]
    public void Names_weight_and_slant_are_the_fonts()
    {
        var font = FontBuilder.TrueType("Square Ünit", 4, 'A').With("OS/2", Style(weight: 700, selection: 1)).Read();

        Assert.Equal(("Square Ünit", "Square Ünit", 700, true, true), (font.Name, font.FamilyName, font.Weight, font.IsItalic, font.IsOutline));
        Assert.Equal((400, false), FontBuilder.TrueType("Old", 4, 'A').Without("OS/2").Read() is var old ? (old.Weight, old.IsItalic) : default);
    }

    [Theory]
    [InlineData("cmap")]
    [InlineData("glyf")]
    [InlineData("head")]
    [InlineData("hhea")]
    [InlineData("hmtx")]
    [InlineData("loca")]
    [InlineData("maxp")]
    [InlineData("name")]
    public void A_font_without_one_of_its_tables_is_broken(string table) => Assert.Throws<BrokenFontException>(() => FontBuilder.TrueType("Bare", 4, 'A').Without(table).Read());

    [Fact]
    public void A_character_whose_glyph_is_missing_is_broken() =>
        Assert.Throws<BrokenFontException>(() => FontBuilder.TrueType("Short", 4, 'A').With("maxp", [.. FontBuilder.U32(0x10000), .. FontBuilder.U16(1), .. new byte[26]]).Read().GlyphOf('A'));

    private static (double Ascent, double Descent, double Line) Heights(FontBuilder font) =>
        font.Read().Metrics is var metrics ? (metrics.Ascent, metrics.Descent, metrics.LineSpacing) : default;

    /// <summary>OS/2 of version 4 with typographic heights of 700, -300 and 50.</summary>
    private static byte[] Style(int weight = 400, int selection = 0, int capHeight = 0)
    {
        var table = new byte[96];
        foreach (var (offset, value) in ((int, int)[])[(0, 4), (4, weight), (62, selection), (68, 700), (70, -300), (72, 50), (88, capHeight)])
            BinaryPrimitives.WriteInt16BigEndian(table.AsSpan(offset), (short)value);
        return table;
    }
}
