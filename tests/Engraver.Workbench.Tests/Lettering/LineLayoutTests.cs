using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Lettering;

namespace Engraver.Workbench.Tests.Lettering;

/// <summary>TEXT and attributes are placed as the DXF reference defines: by hand for squares of 4 mm at a distance of 6, and for every combination by the
/// second calculation.</summary>
public class LineLayoutTests
{
    private static readonly WrittenText s_two = new() { Raw = "HH", Height = 4.0, Insertion = new Vector3D(10.0, 20.0, 0.0) };

    public static TheoryData<string, double, double, double, double> Corners => new()
    {
        { "left", 11, 20, 21, 24 },
        { "centre", 5, 20, 15, 24 },
        { "right", -1, 20, 9, 24 },
        { "bottom left", 11, 22, 21, 26 },
        { "middle right", -1, 18, 9, 22 },
        { "top centre", 5, 16, 15, 20 },
        { "middle", 5, 18, 15, 22 },
        { "aligned", 12, 20, 32, 28 },
        { "fit", 12, 20, 32, 24 },
        { "rotated by 90", 6, 21, 10, 31 },
        { "twice as wide", 12, 20, 32, 24 },
        { "slanted by 45", 11, 20, 25, 24 },
        { "backwards", -1, 20, 9, 24 },
        { "upside down", 11, 16, 21, 20 },
        { "negative width", -1, 20, 9, 24 },
        { "extruded down", -21, 20, -11, 24 },
        { "mirrored block", -42, 20, -22, 24 },
        { "rotated block", -24, 11, -20, 21 },
    };

    [Theory]
    [MemberData(nameof(Corners))]
    public void A_text_of_squares_has_the_corners_calculated_by_hand(string form, double minX, double minY, double maxX, double maxY)
    {
        var second = s_two.Insertion;
        var end = new Vector3D(34.0, 20.0, 0.0);
        var written = form switch
        {
            "centre" => s_two with { Horizontal = 1, Second = second },
            "right" => s_two with { Horizontal = 2, Second = second },
            "bottom left" => s_two with { Vertical = 1, Second = second },
            "middle right" => s_two with { Horizontal = 2, Vertical = 2, Second = second, Insertion = default },
            "top centre" => s_two with { Horizontal = 1, Vertical = 3, Second = second },
            "middle" => s_two with { Horizontal = 4, Second = second },
            "aligned" => s_two with { Horizontal = 3, Second = end },
            "fit" => s_two with { Horizontal = 5, Second = end },
            "rotated by 90" => s_two with { Rotation = Angle.FromDegrees(90.0) },
            "twice as wide" => s_two with { WidthFactor = 2.0 },
            "slanted by 45" => s_two with { Oblique = Angle.FromDegrees(45.0) },
            "backwards" => s_two with { Generation = TextGeneration.Backwards },
            "upside down" => s_two with { Generation = TextGeneration.UpsideDown },
            "negative width" => s_two with { WidthFactor = -1.0 },
            "extruded down" => s_two with { Extrusion = new Vector3D(0.0, 0.0, -1.0) },
            _ => s_two,
        };
        var inserts = form switch
        {
            "mirrored block" => Placement.FromInsert(new Vector3D(-2.0, 1.0, 1.0), Angle.Zero),
            "rotated block" => Placement.FromInsert(new Vector3D(1.0, 1.0, 1.0), Angle.FromDegrees(90.0)),
            _ => Placement.Identity,
        };

        Assert.Equal((minX, minY, maxX, maxY), LetteredLine.BoxOf(written, inserts));
    }

    /// <summary>15 alignments, and for each of them every rotation, width, slant, generation, insert and extrusion.</summary>
    [Theory]
    [InlineData(0, 0)]
    [InlineData(0, 1)]
    [InlineData(0, 2)]
    [InlineData(0, 3)]
    [InlineData(1, 0)]
    [InlineData(1, 1)]
    [InlineData(1, 2)]
    [InlineData(1, 3)]
    [InlineData(2, 0)]
    [InlineData(2, 1)]
    [InlineData(2, 2)]
    [InlineData(2, 3)]
    [InlineData(3, 0)]
    [InlineData(4, 0)]
    [InlineData(5, 0)]
    public void Every_form_is_where_the_second_calculation_has_it(int horizontal, int vertical)
    {
        foreach (var (font, raw) in new[] { ("engraver", "Ag%%c 3%%u5%%d%%u"), (LetteredLine.Outlines, "AVE %%oB%%o1") })
        {
            var fonts = LetteredLine.Fonts(font);
            foreach (var written in Forms(raw, horizontal, vertical))
            {
                foreach (var inserts in Inserts())
                {
                    var text = LetteredLine.Text(written, inserts);
                    var style = fonts.StyleOf(text.Style);
                    var curves = LetterCurves.Of(LineLayout.Of(text, fonts)!, LetteredLine.MaxError);
                    var found = LetterCheck.Find(LetterPlaces.Of(text, style, fonts.Of(style)), curves, LetteredLine.MaxError);
                    Assert.True(found is null, $"{found} {written} {inserts}");
                    Assert.NotEmpty(curves.Parts);
                }
            }
        }
    }

    [Fact]
    public void The_second_calculation_finds_a_curve_that_is_a_millionth_beside_its_place_and_one_too_many()
    {
        var fonts = LetteredLine.Fonts(LetteredLine.Squares);
        var places = LetterPlaces.Of(LetteredLine.Text(s_two), fonts.StyleOf("S"), fonts.Of(fonts.StyleOf("S")));
        var longer = LetterPlaces.Of(LetteredLine.Text(s_two with { Raw = "HHH" }), fonts.StyleOf("S"), fonts.Of(fonts.StyleOf("S")));

        Assert.Null(Found(places, s_two));
        Assert.InRange(Found(places, s_two with { Height = 4.0 + 4e-6 })!.Value.Distance, 4e-6, 2e-5);
        Assert.Equal(double.PositiveInfinity, Found(longer, s_two)!.Value.Distance);
        Assert.Equal(double.PositiveInfinity, Found(places, s_two with { Raw = "HHH" })!.Value.Distance);

        static Misplacement? Found(LetterPlaces places, WrittenText cut) => LetterCheck.Find(places, LetteredLine.CurvesOf(cut), maxError: 1e-6);
    }

    [Theory]
    [InlineData("%%c10%%p1%%d", "\u230010±1°")]
    [InlineData("%%uA%%uB%%%", "AB%")]
    [InlineData("%%065%%090", "AZ")]
    [InlineData("\\U+00C4\\U+03A9", "ÄΩ")]
    [InlineData("A\u0308", "Ä")]
    public void Codes_are_the_characters_that_they_stand_for(string raw, string shown)
    {
        var layout = LineLayout.Of(LetteredLine.Text(s_two with { Raw = raw }), LetteredLine.Fonts("engraver"))!;

        Assert.Equal(shown, string.Concat(layout.Glyphs.Select(glyph => char.ConvertFromUtf32(glyph.CodePoint))));
        Assert.Empty(layout.Notes);
    }

    [Fact]
    public void Underlines_and_overlines_are_as_long_as_their_letters()
    {
        var layout = LineLayout.Of(LetteredLine.Text(s_two with { Raw = "H%%uH%%oH%%u%%oH" }), LetteredLine.Fonts(LetteredLine.Squares))!;

        Assert.Equal([(6.0, 12.0, -0.8), (12.0, 18.0, -0.8), (12.0, 18.0, 4.8)], layout.Rules.Select(rule => (Math.Round(rule.From.X, 9), Math.Round(rule.To.X, 9), Math.Round(rule.From.Y, 9))));
    }

    [Fact]
    public void A_fixed_height_of_the_style_applies_where_the_text_states_none()
    {
        var layout = LineLayout.Of(LetteredLine.Text(s_two with { Height = 0.0 }), LetteredLine.Fonts(LetteredLine.Squares, fixedHeight: 8.0))!;

        Assert.Equal(0.02, layout.Glyphs[0].Map.YAxis.Y, 12);
        Assert.Null(LineLayout.Of(LetteredLine.Text(s_two with { Height = 0.0 }), LetteredLine.Fonts(LetteredLine.Squares)));
        Assert.Null(LineLayout.Of(LetteredLine.Text(s_two with { WidthFactor = 0.0 }), LetteredLine.Fonts(LetteredLine.Squares)));
        Assert.Null(LineLayout.Of(LetteredLine.Text(s_two with { Horizontal = 5, Second = s_two.Insertion }), LetteredLine.Fonts(LetteredLine.Squares)));
    }

    [Fact]
    public void A_character_that_the_font_lacks_has_the_stroke_fonts_shape_and_one_that_no_font_has_is_a_box()
    {
        var layout = LineLayout.Of(LetteredLine.Text(s_two with { Raw = "HB\u4e2dH" }), LetteredLine.Fonts(LetteredLine.Squares))!;

        Assert.Equal(['H', 'B', 0, 'H'], layout.Glyphs.Select(glyph => glyph.CodePoint));
        Assert.Equal([(LayoutNoteKind.GlyphSubstituted, "B (U+0042)"), (LayoutNoteKind.GlyphMissing, "\u4e2d (U+4E2D)")], layout.Notes.Select(note => (note.Kind, note.Detail)));
        Assert.Equal("Engraver", layout.Glyphs[1].Font.Font.Name);
    }

    /// <summary>Two squares that overlap in each letter are one outline of eight lines: it is compared with the outlines of the font.</summary>
    [Fact]
    public void Outlines_that_were_united_are_compared_with_those_of_the_font()
    {
        var written = s_two with { Raw = "ÅÅ", Height = 20.0 };
        var fonts = LetteredLine.Fonts(LetteredLine.Crossing);
        var style = fonts.StyleOf("S");
        var places = LetterPlaces.Of(LetteredLine.Text(written), style, fonts.Of(style));
        var united = LetteredLine.CurvesOf(written, font: LetteredLine.Crossing);
        var moved = LetteredLine.CurvesOf(written with { Insertion = new Vector3D(10.1, 20.0, 0.0) }, font: LetteredLine.Crossing);

        Assert.Equal(2 * 8, united.Parts.Count);
        Assert.Null(LetterCheck.Find(places, united, LetteredLine.MaxError));
        Assert.InRange(LetterCheck.Find(places, moved, LetteredLine.MaxError)!.Value.Distance, 0.05, 0.2);
    }

    [Fact]
    public void A_diameter_sign_is_the_fonts_own_letter_with_a_stroke_where_it_has_no_other()
    {
        var layout = LineLayout.Of(LetteredLine.Text(s_two with { Raw = "%%c" }), LetteredLine.Fonts(LetteredLine.Crossing))!;

        Assert.Equal((0xD8, 0), (layout.Glyphs[0].CodePoint, layout.Notes.Count));
    }

    private static IEnumerable<WrittenText> Forms(string raw, int horizontal, int vertical) =>
        from turn in new[] { 0.0, 37.0, 270.0 }
        from width in new[] { 1.0, 0.7, -1.3 }
        from slant in new[] { 0.0, 15.0, -40.0 }
        from generation in new[] { TextGeneration.None, TextGeneration.Backwards, TextGeneration.UpsideDown, TextGeneration.Backwards | TextGeneration.UpsideDown }
        from extrusion in new[] { default, new Vector3D(0.0, 0.0, -1.0), new Vector3D(0.0, 1.0, 1.0), new Vector3D(1e-3, -2e-3, 0.1) }
        select new WrittenText
        {
            Raw = raw,
            Height = 3.5,
            Insertion = new Vector3D(12.0, -7.0, 1.0),
            Second = horizontal == 0 && vertical == 0 ? null : new Vector3D(40.0, 5.0, 1.0),
            Horizontal = horizontal,
            Vertical = vertical,
            Rotation = Angle.FromDegrees(turn),
            WidthFactor = width,
            Oblique = Angle.FromDegrees(slant),
            Generation = generation,
            Extrusion = extrusion,
        };

    private static IEnumerable<Placement> Inserts()
    {
        yield return Placement.Identity;
        yield return Placement.FromInsert(new Vector3D(-1.0, 1.0, 1.0), Angle.FromDegrees(30.0)).MovedBy(new Vector3D(100.0, 200.0, 0.0));
        yield return Placement.FromInsert(new Vector3D(2.0, 0.5, 1.0), Angle.FromDegrees(-75.0)).After(Placement.FromInsert(new Vector3D(1.0, -3.0, 2.0), Angle.FromDegrees(20.0)).MovedBy(new Vector3D(-5.0, 8.0, 0.0)));
    }
}
