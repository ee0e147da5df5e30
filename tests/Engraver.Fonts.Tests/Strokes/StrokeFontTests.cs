using Engraver.Fonts.Strokes;

namespace Engraver.Fonts.Tests.Strokes;

/// <summary>The drawn font: complete, connected, within its heights, and of arcs that a machine can follow.</summary>
public class StrokeFontTests
{
    /// <summary>Letters that are drawn in one part; their accents add their own parts.</summary>
    private const string OnePart = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghklmnopqrstuvwxyzıȷÆæŒœØøÐðÞþßẞĐđĦħŁłŦŧŊŋĸſƒƠơƯưÇçŞşĄąĘęĮŲųǪǫ"
        + "ΓΔΛΠΣΦΨΩαβγδεζηθικλμνξοπρςστυφχψωБДЖЗИЛУЦЧШЩЪЬЭЄЮЯҐЂЋЉЊЏбвгджзиклмнптфцчшщъьэєюяґђљњџ123456789$&@#€£¥¢₽₴₺₤₹₩+−→↗⌀∠⟂⏥⌭⌖";

    private static readonly StrokeFont s_font = StrokeFont.Engraver;

    public static TheoryData<string, int> PartsOfSigns => new()
    {
        { "0ijЫы", 2 }, { "ËÄÖÜЁїÏΪŐ", 3 }, { "Ξ", 3 }, { "ÉÁÀÂÃÅÑĂĀŮ", 2 }, { "%", 3 }, { "÷", 3 }, { "=", 2 }, { ":", 2 }, { "ẤỂ", 3 },
    };

    [Fact]
    public void Every_required_character_has_a_shape() =>
        Assert.Empty(StrokeGlyphs.Required().Where(code => !s_font.Contains(code)).Select(StrokeGlyphs.Named));

    [Fact]
    public void Only_spaces_have_no_strokes() =>
        Assert.Equal([0x20, 0xA0, 0x2007, 0x202F], s_font.CodePoints.Where(code => s_font.GlyphOf(code)!.Contours.Count == 0));

    [Fact]
    public void Every_glyph_has_a_positive_advance_and_is_within_the_heights_and_near_its_width() => Assert.Empty(Glyphs().Where(glyph =>
    {
        var points = StrokeGlyphs.Pieces(glyph.Curves).SelectMany(piece => piece.Extremes()).ToList();
        return glyph.Curves.Advance is not (> 0 and < 1500)
            || points.Any(point => point.Y > s_font.Metrics.Ascent || point.Y < -s_font.Metrics.Descent || point.X < -100 || point.X > glyph.Curves.Advance + 130);
    }).Select(glyph => glyph.Name));

    [Fact]
    public void Every_stroke_is_connected_and_closes_exactly() => Assert.Empty(Glyphs().Where(glyph => glyph.Curves.Contours.Any(contour =>
        contour.Pieces.Count == 0 || (contour.IsClosed && contour.Pieces[^1].End != contour.Start))).Select(glyph => glyph.Name));

    [Fact]
    public void Pieces_are_lines_and_arcs_of_sane_lengths_and_radii() => Assert.Empty(Glyphs().Where(glyph =>
        glyph.Curves.Contours.SelectMany(contour => contour.Pieces).Any(piece => piece.Kind is not (GlyphPieceKind.Line or GlyphPieceKind.Arc))
        || StrokeGlyphs.Pieces(glyph.Curves).Any(piece => !(piece.Length is > 5 and < 2500) || (!piece.IsLine && !(piece.Radius is > 9 and < 3000 && Math.Abs(piece.Sweep) < 1.9 * Math.PI)))).Select(glyph => glyph.Name));

    [Fact]
    public void A_letter_that_is_one_shape_has_no_separate_strokes() => Assert.DoesNotContain(OnePart, letter => StrokeGlyphs.Parts(s_font.GlyphOf(letter)!) != 1);

    [Theory]
    [MemberData(nameof(PartsOfSigns))]
    public void Accents_and_dots_do_not_touch_the_letter(string letters, int parts) =>
        Assert.DoesNotContain(letters, letter => StrokeGlyphs.Parts(s_font.GlyphOf(letter)!) != parts);

    [Fact]
    public void An_accent_is_above_its_letter_or_below() => Assert.DoesNotContain("ÀÁÂÃÄÅÇĂĄŐŮČĎŇĢŞȘỆẶЁЙЎΪ", letter =>
    {
        var glyph = s_font.GlyphOf(letter)!;
        var separate = glyph.Contours.Where(contour => StrokeGlyphs.Pieces(contour).SelectMany(piece => piece.Extremes()).All(point => point.Y >= 700 + 50 || point.Y <= 0));
        return !separate.Any();
    });

    [Theory]
    [InlineData("abcdeghmnopqrstuSCGOQUDJ0236890@&€θσφ", 0.6)]
    public void Arcs_join_arcs_without_a_corner(string letters, double degrees) => Assert.DoesNotContain(letters, letter => s_font.GlyphOf(letter)!.Contours.Any(contour =>
    {
        var pieces = StrokeGlyphs.Pieces(contour);
        return pieces.Zip(pieces.Skip(1)).Any(pair => !pair.First.IsLine && !pair.Second.IsLine
            && Math.Abs(Math.IEEERemainder(pair.First.EndDirection - pair.Second.StartDirection, 2 * Math.PI)) * 180 / Math.PI > degrees);
    }));

    [Fact]
    public void Digits_have_one_width() => Assert.Equal([560.0], "0123456789".Select(digit => s_font.GlyphOf(digit)!.Advance).Select(advance => Math.Round(advance, 9)).Distinct());

    [Fact]
    public void Capitals_have_the_cap_height() => Assert.DoesNotContain("BCDEFGHIKLMNOPRSTUVWXYZ0123456789", letter =>
        s_font.GlyphOf(letter)!.Contours.SelectMany(StrokeGlyphs.Pieces).SelectMany(piece => piece.Extremes()) is var points
        && (Math.Abs(points.Max(point => point.Y) - 700) > 1e-6 || Math.Abs(points.Min(point => point.Y)) > 1e-6));

    [Theory]
    [InlineData('0', 'O')]
    [InlineData('1', 'l')]
    [InlineData('1', 'I')]
    [InlineData('l', 'I')]
    [InlineData('5', 'S')]
    [InlineData('8', 'B')]
    public void Characters_that_are_confused_have_different_shapes(char one, char other) => Assert.NotEqual(Shape(one), Shape(other));

    [Fact]
    public void A_character_that_the_font_does_not_have_is_null()
    {
        Assert.False(s_font.Contains(0x4E00));
        Assert.Null(s_font.GlyphOf(0x4E00));
        Assert.Null(s_font.GlyphOf(0x301));
    }

    /// <summary>The number of contours, and of lines and arcs of each.</summary>
    private static string Shape(char letter) =>
        string.Join(' ', s_font.GlyphOf(letter)!.Contours.Select(contour => string.Concat(contour.Pieces.Select(piece => piece.Kind == GlyphPieceKind.Arc ? 'a' : 'l'))));

    private static IEnumerable<(string Name, GlyphCurves Curves)> Glyphs() => s_font.CodePoints.Select(code => (StrokeGlyphs.Named(code), s_font.GlyphOf(code)!));
}
