using Avalonia;
using Avalonia.Media;
using Engraver.Fonts.OpenType;
using Engraver.SoftwarePlatform.Tests.Drawing;
using Engraver.SoftwarePlatform.Text;
using Engraver.TestKit;

namespace Engraver.SoftwarePlatform.Tests.Text;

public class FontFileTests
{
    /// <summary>Operand bytes of small whole numbers in charstrings.</summary>
    private static byte[] N(int value) => value is >= -107 and <= 107 ? [(byte)(value + 139)] : [28, .. FontBuilder.U16(value)];

    [Theory]
    [InlineData(4)]
    [InlineData(6)]
    [InlineData(12)]
    public void Character_maps_of_three_formats_are_understood(int format)
    {
        var font = Open(FontBuilder.TrueType("Square", format, 'A', 'C').Build());

        Assert.Equal(1, font.GlyphTypeface.CharacterToGlyphMap['A']);
        Assert.Equal(1, font.GlyphTypeface.CharacterToGlyphMap['C']);
        Assert.False(font.GlyphTypeface.CharacterToGlyphMap.ContainsGlyph('B'));
        Assert.Equal("Square", font.FamilyName);
    }

    [Fact]
    public void A_TrueType_square_is_a_square() =>
        Assert.Equal(new Rect(100, 0, 400, 400), Open(FontBuilder.TrueType("Square", 4, 'A').Build()).Outline(1).ControlBounds(Matrix.Identity));

    [Fact]
    public void A_glyph_made_of_itself_is_left_blank_instead_of_going_on_for_ever()
    {
        byte[] composite = [.. U(-1), .. new byte[8], .. U(0x0001 | 0x0002), .. U(1), .. U(50), .. U(60)];
        var font = Open(FontBuilder.TrueType("Loop", 4, 'A').With("glyf", composite).With("loca", [.. U(0), .. U(0), .. U(composite.Length / 2)]).Build());

        Assert.True(font.Outline(1).IsEmpty);
    }

    [Fact]
    public void A_program_that_calls_itself_or_lacks_operands_leaves_a_blank()
    {
        byte[] endless = [.. N(-107), 10, 11];

        Assert.True(Open(FontBuilder.Cff("Endless", [.. N(-107), 10, 14], endless).Build()).Outline(1).IsEmpty);
        Assert.True(Open(FontBuilder.Cff("Lacking", [.. N(1), 21, 14]).Build()).Outline(1).IsEmpty);
        Assert.True(Open(FontBuilder.Cff("Unknown", [.. N(1), 13, 14]).Build()).Outline(1).IsEmpty);
    }

    [Fact]
    public void Each_face_of_a_collection_is_a_font()
    {
        var file = FontBuilder.Collection(FontBuilder.TrueType("First", 4, 'A'), FontBuilder.Cff("Second", [.. N(0), .. N(0), 21, .. N(70), .. N(70), .. N(-70), 6, 14], characters: 'B'));
        var source = new MemoryFontSource(file);

        Assert.Equal(2, FontFile.CountFaces(source));
        Assert.Equal(["First", "Second"], Enumerable.Range(0, 2).Select(i => SoftwareTypeface.TryCreate(source, i, FontSimulations.None)!.FamilyName));
        Assert.Null(SoftwareTypeface.TryCreate(source, 2, FontSimulations.None));
        Assert.Equal(new Rect(0, 0, 70, 70), SoftwareTypeface.TryCreate(source, 1, FontSimulations.None)!.Outline(1).ControlBounds(Matrix.Identity));
    }

    [Fact]
    public void Wherever_a_font_is_cut_off_or_changed_nothing_breaks()
    {
        var random = new Random(7);
        foreach (var good in new[] { FontBuilder.TrueType("Square", 4, 'A').Build(), FontBuilder.Cff("Lines", [.. N(100), .. N(50), 21, .. N(300), 6, .. N(200), 7, 14]).Build() })
        {
            for (var round = 0; round < 400; round++)
            {
                var bad = good.ToArray();
                for (var i = 0; i < 1 + round % 8; i++)
                    bad[random.Next(bad.Length)] = (byte)random.Next(256);
                var font = SoftwareTypeface.TryCreate(new MemoryFontSource(bad.AsMemory(0, round % 3 == 0 ? random.Next(bad.Length) : bad.Length)), 0, FontSimulations.None);
                font?.Outline(1);
                font?.Kerning.Between(0, 1);
            }
        }
    }

    [Fact]
    public void A_font_whose_widths_are_missing_is_not_used()
    {
        var hhea = new byte[36];
        hhea[1] = 1;

        Assert.Null(SoftwareTypeface.TryCreate(new MemoryFontSource(FontBuilder.TrueType("Widthless", 4, 'A').With("hhea", hhea).Build()), 0, FontSimulations.None));
    }

    [Fact]
    public void A_made_bold_is_heavier_and_a_made_italic_leans()
    {
        var plain = Open(FontBuilder.TrueType("Square", 4, 'A').Build());
        var bold = plain.TrySimulate(FontSimulations.Bold)!;
        var oblique = plain.TrySimulate(FontSimulations.Oblique)!;

        Assert.True(Area(bold) > Area(plain) * 1.08);
        Near.Equal(plain.Outline(1).ControlBounds(plain.GlyphTransform(1000))!.Value.Right + 100, oblique.Outline(1).ControlBounds(oblique.GlyphTransform(1000))!.Value.Right, 1e-9);
    }

    private static byte[] U(int value) => FontBuilder.U16(value);

    private static SoftwareTypeface Open(byte[] file) =>
        SoftwareTypeface.TryCreate(new MemoryFontSource(file), 0, FontSimulations.None) ?? throw new InvalidOperationException("The font of the test is not readable.");

    private static double Area(SoftwareTypeface font)
    {
        var geometry = new Engraver.SoftwarePlatform.Geometry.SoftwareGeometry(font.Outline(1));
        using var picture = new Picture(600, 600).Draw(c =>
        {
            c.Transform = Matrix.CreateTranslation(50, 50);
            c.DrawGeometry(Picture.Brush(Colors.Black), null, geometry);
        });
        return picture.Area();
    }
}
