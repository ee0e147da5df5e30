using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Tests.Drawing;
using Engraver.SoftwarePlatform.Text;

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
    public void A_component_is_scaled_and_moved()
    {
        // Glyph 1 becomes glyph 0's square at half size, 50 to the right and 60 up; glyph 0 is the square.
        byte[] square = [.. U(1), .. U(100), .. U(0), .. U(500), .. U(400), .. U(3), .. U(0), 1, 1, 1, 1, .. U(100), .. U(0), .. U(400), .. U(0), .. U(0), .. U(400), .. U(0), .. U(-400)];
        byte[] composite = [.. U(-1), .. new byte[8], .. U(0x0001 | 0x0002 | 0x0008), .. U(0), .. U(50), .. U(60), .. U(0x2000)];
        var font = Open(FontBuilder.TrueType("Composite", 4, 'A')
            .With("glyf", [.. square, .. composite])
            .With("loca", [.. U(0), .. U(square.Length / 2), .. U((square.Length + composite.Length) / 2)])
            .Build());

        Assert.Equal(new Rect(100, 60, 200, 200), font.Outline(1).ControlBounds(Matrix.Identity));
    }

    [Fact]
    public void A_glyph_made_of_itself_is_left_blank_instead_of_going_on_for_ever()
    {
        byte[] composite = [.. U(-1), .. new byte[8], .. U(0x0001 | 0x0002), .. U(1), .. U(50), .. U(60)];
        var font = Open(FontBuilder.TrueType("Loop", 4, 'A').With("glyf", composite).With("loca", [.. U(0), .. U(0), .. U(composite.Length / 2)]).Build());

        Assert.True(font.Outline(1).IsEmpty);
    }

    [Fact]
    public void A_charstring_of_lines_draws_its_shape()
    {
        // 600 (width) 100 50 rmoveto 300 hlineto 200 vlineto -300 hlineto endchar.
        byte[] program = [.. N(600), .. N(100), .. N(50), 21, .. N(300), 6, .. N(200), 7, .. N(-300), 6, 14];
        var font = Open(FontBuilder.Cff("Lines", program).Build());

        Assert.Equal(new Rect(100, 50, 300, 200), font.Outline(1).ControlBounds(Matrix.Identity));
        Near.Equal(300 * 200, Area(font), 10);
    }

    [Fact]
    public void Curves_in_all_their_short_forms_make_a_circle()
    {
        // Quarter circles of radius 200 with handles of 110, once as general curves and once as curves that begin and end along the axes in turn.
        byte[] alternating = [.. N(300), .. N(100), 21, .. N(110), .. N(90), .. N(90), .. N(110), .. N(110), .. N(-90), .. N(90), .. N(-110), .. N(-110), .. N(-90), .. N(-90), .. N(-110), .. N(-110), .. N(90), .. N(-90), .. N(110), 31, 14];
        byte[] general = [.. N(300), .. N(100), 21, .. Six(110, 0, 90, 90, 0, 110), .. Six(0, 110, -90, 90, -110, 0), .. Six(-110, 0, -90, -90, 0, -110), .. Six(0, -110, 90, -90, 110, 0), 8, 14];

        Near.Equal(Math.PI * 200 * 200, Area(Open(FontBuilder.Cff("General", general).Build())), 300);
        Near.Equal(Math.PI * 200 * 200, Area(Open(FontBuilder.Cff("Alternating", alternating).Build())), 300);
    }

    [Fact]
    public void Curves_that_keep_their_direction_and_flexes_end_where_they_should()
    {
        // A start aside, then hhcurveto; vvcurveto back up; flex along a straight line.
        byte[] program =
        [
            .. N(0), .. N(0), 21,
            .. N(10), .. N(50), .. N(50), .. N(20), .. N(50), 27,
            .. N(40), .. N(30), .. N(30), .. N(40), 26,
            .. N(-20), .. N(-30), .. N(5), .. N(-30), .. N(-30), .. N(-30), .. N(-40), 12, 34,
            14,
        ];
        var font = Open(FontBuilder.Cff("Flex", program).Build());

        // 150 right and 30 up, then 30 right and 110 up, then 180 to the left at the same height by way of 5 above.
        Assert.Equal(new Rect(0, 0, 180, 145), font.Outline(1).ControlBounds(Matrix.Identity));
    }

    [Fact]
    public void Hints_and_masks_are_stepped_over()
    {
        // Two horizontal hints, one vertical one implied by hintmask: one mask byte.
        byte[] program = [.. N(0), .. N(20), .. N(100), .. N(20), 18, .. N(5), .. N(10), 19, 0b1110_0000, .. N(100), 22, .. N(50), .. N(60), .. N(-50), 6, 14];
        var font = Open(FontBuilder.Cff("Hints", program).Build());

        Assert.Equal(new Rect(100, 0, 50, 60), font.Outline(1).ControlBounds(Matrix.Identity));
    }

    [Fact]
    public void Subroutines_of_the_font_and_of_the_table_are_called()
    {
        byte[] local = [.. N(200), 6, .. N(-107), 29, 11];
        byte[] global = [.. N(200), 7, .. N(-200), 6, 11];
        byte[] program = [.. N(100), .. N(0), 21, .. N(-107), 10, 14];
        var font = Open(FontBuilder.Cff("Calls", program, local, global).Build());

        Assert.Equal(new Rect(100, 0, 200, 200), font.Outline(1).ControlBounds(Matrix.Identity));
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

    private static byte[] Six(params int[] values) => [.. values.SelectMany(N)];

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
