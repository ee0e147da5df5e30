using Engraver.Fonts.OpenType;
using Engraver.TestKit;

namespace Engraver.Fonts.Tests.OpenType;

/// <summary>Shapes of small fonts that the tests write.</summary>
public class OutlineTests
{
    private static readonly byte[] s_square = [.. U(1), .. U(100), .. U(0), .. U(500), .. U(400), .. U(3), .. U(0), 1, 1, 1, 1, .. U(100), .. U(0), .. U(400), .. U(0), .. U(0), .. U(400), .. U(0), .. U(-400)];

    [Fact]
    public void A_TrueType_square_is_four_lines_that_end_at_its_start()
    {
        var contour = Assert.Single(Glyph(FontBuilder.TrueType("Square", 4, 'A')).Contours);

        Assert.True(contour.IsClosed);
        Assert.Equal(new FontPoint(100, 0), contour.Start);
        Assert.Equal([GlyphPiece.Line(new(100, 400)), GlyphPiece.Line(new(500, 400)), GlyphPiece.Line(new(500, 0)), GlyphPiece.Line(new(100, 0))], contour.Pieces);
    }

    [Fact]
    public void Control_points_in_a_row_have_points_of_the_curve_between_them()
    {
        // Four control points, none on the curve: a rounded square that begins halfway between the last and the first.
        byte[] glyph = [.. U(1), .. U(100), .. new byte[6], .. U(3), .. U(0), 0, 0, 0, 0, .. U(100), .. U(400), .. U(0), .. U(-400), .. U(0), .. U(0), .. U(400), .. U(0)];
        var contour = Assert.Single(Glyph(WithGlyph("Round", glyph)).Contours);

        Assert.Equal(new FontPoint(100, 200), contour.Start);
        Assert.Equal(
            [
                GlyphPiece.Quadratic(new(100, 0), new(300, 0)), GlyphPiece.Quadratic(new(500, 0), new(500, 200)),
                GlyphPiece.Quadratic(new(500, 400), new(300, 400)), GlyphPiece.Quadratic(new(100, 400), new(100, 200)),
            ],
            contour.Pieces);
    }

    [Fact]
    public void The_table_of_widths_decides_where_the_left_edge_is() =>
        Assert.Equal((130.0, 0.0, 530.0, 400.0), GlyphShape.ControlBox(Glyph(FontBuilder.TrueType("Aside", 4, 'A').With("hmtx", [.. U(600), .. U(0), .. U(130)]))));

    [Fact]
    public void A_component_is_scaled_and_moved() =>
        Assert.Equal((100.0, 60.0, 300.0, 260.0), GlyphShape.ControlBox(Composite([.. U(0x0001 | 0x0002 | 0x0008), .. U(0), .. U(50), .. U(60), .. U(0x2000)])));

    [Fact]
    public void A_component_is_placed_by_points()
    {
        // The square at half size, its corner 0 (50, 0) on the corner 2 (500, 400) of the square before it.
        byte[] components = [.. U(0x0002 | 0x0020), .. U(0), 0, 0, .. U(0x0008), .. U(0), 2, 0, .. U(0x2000)];
        var glyph = Composite(components);

        Assert.Equal(2, glyph.Contours.Count);
        Assert.Equal(new FontPoint(500, 400), glyph.Contours[1].Start);
        Assert.Equal((100.0, 0.0, 700.0, 600.0), GlyphShape.ControlBox(glyph));
    }

    [Fact]
    public void A_component_is_turned_by_a_matrix() =>
        Assert.Equal((-400.0, 100.0, 0.0, 500.0), GlyphShape.ControlBox(Composite([.. U(0x0002 | 0x0080), .. U(0), 0, 0, .. U(0), .. U(0x4000), .. U(-0x4000), .. U(0)])));

    [Theory]
    [InlineData(0x0001 | 0x0002, 1, 50, 60)]
    [InlineData(0x0001 | 0x0002, 9, 50, 60)]
    [InlineData(0x0001, 0, 50, 60)]
    [InlineData(0x0001, 0, 0, 0)]
    public void A_glyph_made_of_itself_of_a_missing_one_or_at_a_missing_point_is_broken(int flags, int component, int first, int second) =>
        Assert.Throws<BrokenFontException>(() => Composite([.. U(flags), .. U(component), .. U(first), .. U(second)]));

    [Fact]
    public void A_glyph_of_countless_components_is_broken()
    {
        // Each of six glyphs has 200 times the one before it.
        byte[] Nested(int glyph) => [.. U(-1), .. new byte[8], .. Enumerable.Range(1, 200).SelectMany(i => (byte[])[.. U(0x0002 | (i < 200 ? 0x0020 : 0)), .. U(glyph), 0, 0])];
        var glyphs = new List<byte[]> { s_square, Nested(5) };
        for (var i = 2; i < 6; i++) glyphs.Add(i == 2 ? Nested(0) : Nested(i - 1));
        var font = FontBuilder.TrueType("Bomb", 4, 'A').With("glyf", [.. glyphs.SelectMany(glyph => glyph)])
            .With("loca", [.. Enumerable.Range(0, 7).SelectMany(i => U(glyphs.Take(i).Sum(glyph => glyph.Length) / 2))]).With("maxp", [.. FontBuilder.U32(0x10000), .. U(6), .. new byte[26]]);

        Assert.Throws<BrokenFontException>(() => Glyph(font));
    }

    [Fact]
    public void A_charstring_of_lines_draws_its_shape()
    {
        // 600 (width) 100 50 rmoveto 300 hlineto 200 vlineto -300 hlineto endchar.
        var glyph = Charstring([.. N(600), .. N(100), .. N(50), 21, .. N(300), 6, .. N(200), 7, .. N(-300), 6, 14]);

        Assert.Equal((100.0, 50.0, 400.0, 250.0), GlyphShape.ControlBox(glyph));
        Assert.Equal(-300 * 200, GlyphShape.Area(glyph));
        Assert.Equal(GlyphPiece.Line(new(100, 50)), Assert.Single(glyph.Contours).Pieces[^1]);
    }

    [Fact]
    public void Curves_in_all_their_short_forms_make_a_circle()
    {
        // Quarter circles of radius 200 with handles of 110, once as general curves and once as curves that begin and end along the axes in turn.
        byte[] alternating = [.. N(300), .. N(100), 21, .. N(110), .. N(90), .. N(90), .. N(110), .. N(110), .. N(-90), .. N(90), .. N(-110), .. N(-110), .. N(-90), .. N(-90), .. N(-110), .. N(-110), .. N(90), .. N(-90), .. N(110), 31, 14];
        byte[] general = [.. N(300), .. N(100), 21, .. Six(110, 0, 90, 90, 0, 110), .. Six(0, 110, -90, 90, -110, 0), .. Six(-110, 0, -90, -90, 0, -110), .. Six(0, -110, 90, -90, 110, 0), 8, 14];

        Assert.Equal(Charstring(general).Contours[0].Pieces, Charstring(alternating).Contours[0].Pieces);
        Assert.Equal(-Math.PI * 200 * 200, GlyphShape.Area(Charstring(general)), 300.0);
        Assert.Equal(GlyphPiece.Cubic(new(410, 100), new(500, 190), new(500, 300)), Charstring(general).Contours[0].Pieces[0]);
    }

    [Fact]
    public void Curves_that_keep_their_direction_and_flexes_end_where_they_should()
    {
        // A start aside, then hhcurveto; vvcurveto back up; flex along a straight line.
        var glyph = Charstring([
            .. N(0), .. N(0), 21,
            .. N(10), .. N(50), .. N(50), .. N(20), .. N(50), 27,
            .. N(40), .. N(30), .. N(30), .. N(40), 26,
            .. N(-20), .. N(-30), .. N(5), .. N(-30), .. N(-30), .. N(-30), .. N(-40), 12, 34,
            14,
        ]);

        // 150 right and 30 up, then 30 right and 110 up, then 180 to the left at the same height by way of 5 above.
        Assert.Equal((0.0, 0.0, 180.0, 145.0), GlyphShape.ControlBox(glyph));
    }

    [Fact]
    public void Hints_and_masks_are_stepped_over() =>
        // Two horizontal hints, one vertical one implied by hintmask: one mask byte.
        Assert.Equal((100.0, 0.0, 150.0, 60.0), GlyphShape.ControlBox(Charstring([.. N(0), .. N(20), .. N(100), .. N(20), 18, .. N(5), .. N(10), 19, 0b1110_0000, .. N(100), 22, .. N(50), .. N(60), .. N(-50), 6, 14])));

    [Fact]
    public void Subroutines_of_the_font_and_of_the_table_are_called()
    {
        byte[] local = [.. N(200), 6, .. N(-107), 29, 11];
        byte[] global = [.. N(200), 7, .. N(-200), 6, 11];

        Assert.Equal((100.0, 0.0, 300.0, 200.0), GlyphShape.ControlBox(Glyph(FontBuilder.Cff("Calls", [.. N(100), .. N(0), 21, .. N(-107), 10, 14], local, global))));
    }

    [Fact]
    public void A_move_without_a_line_and_a_line_there_and_back_bound_no_area() =>
        Assert.Empty(Charstring([.. N(100), .. N(0), 21, .. N(100), .. N(0), 21, .. N(50), 6, 14]).Contours);

    [Fact]
    public void A_program_that_calls_itself_lacks_operands_or_is_unknown_is_broken()
    {
        Assert.Throws<BrokenFontException>(() => Glyph(FontBuilder.Cff("Endless", [.. N(-107), 10, 14], [.. N(-107), 10, 11])));
        Assert.Throws<BrokenFontException>(() => Charstring([.. N(1), 21, 14]));
        Assert.Throws<BrokenFontException>(() => Charstring([.. N(1), 13, 14]));
        Assert.Throws<BrokenFontException>(() => Charstring([.. N(50), 6, 14]));
        Assert.Throws<BrokenFontException>(() => Charstring([.. N(0), .. N(0), .. N(65), .. N(66), 14]));
    }

    [Fact]
    public void A_program_of_countless_calls_is_broken()
    {
        // Twenty thousand calls of a subroutine that has thirty moves.
        byte[] local = [.. Enumerable.Range(0, 30).SelectMany(_ => (byte[])[.. N(1), 22]), 11];

        Assert.Throws<BrokenFontException>(() => Glyph(FontBuilder.Cff("Long", [.. Enumerable.Range(0, 20_000).SelectMany(_ => (byte[])[.. N(-107), 10]), 14], local)));
    }

    private static byte[] U(int value) => FontBuilder.U16(value);

    /// <summary>Operand bytes of small whole numbers in charstrings.</summary>
    private static byte[] N(int value) => value is >= -107 and <= 107 ? [(byte)(value + 139)] : [28, .. FontBuilder.U16(value)];

    private static byte[] Six(params int[] values) => [.. values.SelectMany(N)];

    private static GlyphCurves Charstring(byte[] program) => Glyph(FontBuilder.Cff("Program", program));

    /// <summary>Glyph 1 is made of these components; glyph 0 is the square.</summary>
    private static GlyphCurves Composite(byte[] components)
    {
        byte[] composite = [.. U(-1), .. U(100), .. new byte[6], .. components];
        return Glyph(FontBuilder.TrueType("Composite", 4, 'A').With("glyf", [.. s_square, .. composite])
            .With("loca", [.. U(0), .. U(s_square.Length / 2), .. U((s_square.Length + composite.Length) / 2)]));
    }

    private static FontBuilder WithGlyph(string name, byte[] glyph) =>
        FontBuilder.TrueType(name, 4, 'A').With("glyf", glyph).With("loca", [.. U(0), .. U(0), .. U(glyph.Length / 2)]);

    private static GlyphCurves Glyph(FontBuilder font) => font.Read().GlyphOf('A')!;
}
